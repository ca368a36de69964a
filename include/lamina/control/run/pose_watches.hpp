// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "lamina/control/run/pose_watch.hpp"

namespace lamina {

/// Tells for how long no pose of the nozzle has come for the clouds of any of several sensors (`PoseWatch`).
/// Each sensor may have a clock of its own: a sensor with a wrong clock does not hide that poses come for
/// another.
class PoseWatches {
 public:
  /// @param silence_s  a sensor no longer counts once another one was heard for longer than this without it
  ///   [s]
  explicit PoseWatches(double silence_s) : silence_s_(silence_s) {}

  /// Forgets all sensors.
  void begin() { sensors_.clear(); }

  /// Adds the time stamp of a cloud of a sensor, as `PoseWatch::hear`.
  void hear(const std::string& sensor, std::int64_t stamp_ns, const std::optional<std::int64_t>& tip_ns);

  /// The least `PoseWatch::blind` of the sensors that count [s]; 0 without any.
  double blind(const std::optional<std::int64_t>& tip_ns) const;
  /// Whether the last pose says nothing of the clouds of any sensor that counts. False without any.
  bool isWithoutPose(const std::optional<std::int64_t>& tip_ns) const;
  /// Whether a sensor's last cloud is later than `stamp_ns` less the silence.
  bool isHeard(std::int64_t stamp_ns) const;

 private:
  struct Sensor {
    PoseWatch watch;
    std::int64_t first_ns = 0;  ///< stamp of its first cloud
    std::map<std::string, std::int64_t>
        others_ns;  ///< last stamps of the others when this one was heard last
  };

  bool counts(const std::string& name, const Sensor& sensor) const;

  double silence_s_;
  std::map<std::string, Sensor> sensors_;
};

}  // namespace lamina
