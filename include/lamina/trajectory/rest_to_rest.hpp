// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Duration of a straight motion from rest to rest [s]: d / v + v / a, or 2 sqrt(d / a) if the speed v is not
/// reached [Guacheta2021, eq. 4.5]; 0 for a length of 0.
/// @throws InvalidInput if the length is negative, or speed or acceleration is not positive
double restToRestTime(double length_mm, double speed_mm_s, double acceleration_mm_s2);

/// Duration of a toolpath if the nozzle rests at every waypoint: the reference with which look-ahead is
/// compared. The junction deviation of the limits is not used.
/// @throws InvalidInput if a feed is not positive
ToolpathTime restToRestTime(const Toolpath& toolpath, const MotionLimits& limits);

/// The nozzle tip at one instant of a motion from rest to rest.
struct RestToRestSample {
  double time_s = 0.0;
  Point3 position = Point3::Zero();      ///< [mm, part frame]
  Point3 velocity = Point3::Zero();      ///< [mm/s]
  Point3 acceleration = Point3::Zero();  ///< [mm/s²]; constant on each ramp, 0 between ramps
  WaypointIndex heading_for;             ///< waypoint at which the running motion ends
};

/// Plays a toolpath in which the nozzle rests at every waypoint.
class RestToRestPlayer {
 public:
  /// @throws InvalidInput if the toolpath has no motion, or a feed is not positive
  RestToRestPlayer(const Toolpath& toolpath, const MotionLimits& limits);

  double duration() const { return start_s_.back(); }  ///< [s]
  /// The nozzle at a time, which is clamped to [0, duration]; times may come in any order. Takes logarithmic
  /// time.
  RestToRestSample at(double time_s) const;
  /// The nozzle at the times 0, `step_s`, 2 `step_s`, ... and at the end.
  /// @throws InvalidInput if the step is not positive
  std::vector<RestToRestSample> sampled(double step_s) const;

 private:
  struct Motion {
    Point3 start = Point3::Zero();
    MotionSegment segment;
    WaypointIndex end;
  };
  std::vector<Motion> motions_;
  std::vector<double> start_s_;  ///< start of each motion, and the end of the last
};

}  // namespace lamina
