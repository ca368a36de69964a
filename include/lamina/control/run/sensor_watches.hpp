// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "lamina/control/run/stamped_events.hpp"
#include "lamina/control/run/stuck_watch.hpp"
#include "lamina/control/supervision.hpp"

namespace lamina {

/// Detects which of several sensors are stuck, each by its own clouds: a live sensor does not hide a stuck
/// one.
class SensorWatches {
 public:
  /// Adds a cloud that was taken while the nozzle moved.
  /// @param layer  of the print, at that time
  /// @return whether the sensor is found to be stuck by this cloud
  bool see(const SensedCloud& cloud, std::size_t layer);

  bool isStuck(const std::string& sensor) const;
  /// Whether a sensor that is not stuck has measured in a layer or the one before.
  bool isAnyLive(std::size_t layer) const;

  /// Fills in the members by which `afterWatch` judges a stuck sensor in a layer, for the sensor with the
  /// most equal profiles.
  void judge(std::size_t layer, SensorWatch& seen) const;

 private:
  struct Sensor {
    StuckWatch watch;
    std::size_t layer = 0;  ///< of the last cloud

    bool isStuck() const;
  };
  std::map<std::string, Sensor> sensors_;  ///< by name
};

}  // namespace lamina
