// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/motion_planner.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/toolpath/waypoint_index.hpp"

namespace lamina {

/// Duration of a toolpath.
struct ToolpathTime {
  double total_s = 0.0;
  /// Start of each layer's first motion, one per layer.
  std::vector<double> layer_start_s;
};
/// The time in which the nozzle tip moves from rest at the first waypoint to rest at the last, within the
/// limits. Dwells are included; retractions, heating, rotation of the nozzle and pauses are not. Linear time;
/// memory for the layers only.
/// @throws InvalidInput if a feed is not positive
ToolpathTime estimateTime(const Toolpath& toolpath, const MotionLimits& limits);

/// Start times of the paths of a toolpath.
struct PathTimes {
  double total_s = 0.0;
  /// Start of each path's first motion, after the dwells before it, by layer and path.
  std::vector<std::vector<double>> start_s;
};
/// The times of `estimateTime`, path by path. Linear time.
/// @throws InvalidInput if a feed is not positive
PathTimes estimatePathTimes(const Toolpath& toolpath, const MotionLimits& limits);

/// The duration [s] of all motions at their feeds, without acceleration: the sum of length over feed, a lower
/// bound for any machine.
/// @throws InvalidInput if a feed is not positive
double nominalTime(const Toolpath& toolpath);

/// The nozzle at one instant.
struct NozzleSample {
  double time_s = 0.0;
  Point3 position = Point3::Zero();               ///< [mm, part frame]
  Eigen::Quaterniond orientation = nozzleDown();  ///< part_from_nozzle
  double speed_mm_s = 0.0;
  WaypointIndex heading_for;  ///< waypoint at which the running motion ends
};

/// Plays a toolpath: gives the state of the nozzle at any time, and plans ahead only as far as braking
/// requires. Going forward in time takes time linear in the motions passed; going back starts over. The
/// toolpath must outlive the player.
class ToolpathPlayer {
 public:
  ToolpathPlayer(const Toolpath& toolpath, const MotionLimits& limits);
  ~ToolpathPlayer();
  ToolpathPlayer(ToolpathPlayer&&) noexcept;
  ToolpathPlayer& operator=(ToolpathPlayer&&) noexcept;

  /// The nozzle at a time: before 0 at the first waypoint, after the end at the last.
  /// @throws InvalidInput if the toolpath has no motion, or a feed is not positive
  NozzleSample at(double time_s);
  /// Time at which the nozzle reaches the next waypoint after the time of the last call of `at`; a caller
  /// that passes it to `at` misses no waypoint. Infinite after the end, and before the first call of `at`.
  double nextWaypointTime() const;
  /// Whether the time of the last call of `at` was at or after the end.
  bool isFinished() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace lamina
