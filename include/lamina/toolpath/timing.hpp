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

/// How long a toolpath takes.
struct ToolpathTime {
  double total_s = 0.0;
  std::vector<double>
      layer_start_s;  ///< when the nozzle sets out on the layer's first motion; as many as layers
};

/// The time the nozzle tip needs from rest at the first waypoint to rest at the last, within the limits.
/// Dwells are counted; retractions, heating, turning of the nozzle and pauses are not. Linear time; memory
/// for the layers only.
/// @throws InvalidInput if a feed is not positive
ToolpathTime estimateTime(const Toolpath& toolpath, const MotionLimits& limits);

/// When each path of a toolpath begins.
struct PathTimes {
  double total_s = 0.0;
  std::vector<std::vector<double>>
      start_s;  ///< by layer and path, waiting before its first motion not counted
};

/// The same estimate path by path. Linear time.
/// @throws InvalidInput if a feed is not positive
PathTimes estimatePathTimes(const Toolpath& toolpath, const MotionLimits& limits);

/// The time [s] every motion would take at its feed all the way: the sum of length over feed. Less than any
/// machine needs.
/// @throws InvalidInput if a feed is not positive
double nominalTime(const Toolpath& toolpath);

/// The nozzle at one instant.
struct NozzleSample {
  double time_s = 0.0;
  Point3 position = Point3::Zero();               ///< [mm, part frame]
  Eigen::Quaterniond orientation = nozzleDown();  ///< part_from_nozzle
  double speed_mm_s = 0.0;
  WaypointIndex heading_for;  ///< the waypoint at which the running motion ends
};

/// Plays a toolpath: the nozzle at any time, planning ahead only as far as braking needs. Times that go
/// forward cost the motions in between; a time that goes back starts over. The toolpath must outlive the
/// player.
class ToolpathPlayer {
 public:
  ToolpathPlayer(const Toolpath& toolpath, const MotionLimits& limits);
  ~ToolpathPlayer();
  ToolpathPlayer(ToolpathPlayer&&) noexcept;
  ToolpathPlayer& operator=(ToolpathPlayer&&) noexcept;

  /// The nozzle at `time_s`; before 0 at the first waypoint, after the end at the last.
  /// @throws InvalidInput if the toolpath has no motion, or a feed is not positive
  NozzleSample at(double time_s);
  /// When the motion that runs at the time asked for last ends, which is at a waypoint: asking for it next
  /// misses none. Infinite after the end, and before `at` is called.
  double nextWaypointTime() const;
  /// True once `at` was asked for a time at or after the end.
  bool isFinished() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace lamina
