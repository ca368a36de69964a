// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

namespace lamina {

/// Tells from the time stamps of a sensor's clouds for how long no pose of the nozzle has come. If there is
/// no pose yet, or the last pose is far later than the clouds since their clock was set back, the time counts
/// from the first such cloud.
class PoseWatch {
 public:
  /// Time by which a cloud is older than the last pose only after a clock was set [s].
  static constexpr double kClockBack = 30.0;

  /// Adds the time stamp of a cloud.
  /// @param tip_ns  latest time stamp of a pose; nothing before the first one
  void hear(std::int64_t stamp_ns, const std::optional<std::int64_t>& tip_ns);

  /// Time for which no pose has come, by the last cloud [s]; at most 0 if there is one as new as the cloud, 0
  /// before the first cloud.
  /// @param tip_ns  as in `hear`; poses may have come since
  double blind(const std::optional<std::int64_t>& tip_ns) const;
  /// Whether the last pose says nothing of the clouds' time: there is none, or it is of another clock.
  bool isWithoutPose(const std::optional<std::int64_t>& tip_ns) const;

  /// Time stamp of the last cloud; nothing before the first one.
  const std::optional<std::int64_t>& last() const { return last_ns_; }

 private:
  std::optional<std::int64_t> first_ns_;  ///< of the clouds of which the last pose says nothing
  bool was_without_any_ = false;          ///< whether there was no pose at all when these came
  std::optional<std::int64_t> last_ns_;
};

}  // namespace lamina
