// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Time of a straight motion from rest to rest [s]: d / v + v / a, or 2 sqrt(d / a) where the speed is not
/// reached [Guacheta2021, eq. 4.5]. A length of 0 takes none.
/// @throws InvalidInput if the length is negative, or speed or acceleration is not positive
double restToRestTime(double length_mm, double speed_mm_s, double acceleration_mm_s2);

/// The same for a toolpath that rests at every waypoint: the reference that look-ahead is measured against.
/// The junction deviation of the limits is not used.
/// @throws InvalidInput if a feed is not positive
ToolpathTime restToRestTime(const Toolpath& toolpath, const MotionLimits& limits);

/// The nozzle tip at one instant of a motion from rest to rest.
struct RestToRestSample {
  double time_s = 0.0;
  Point3 position = Point3::Zero();      ///< [mm, part frame]
  Point3 velocity = Point3::Zero();      ///< [mm/s], linear in time between the ends of ramps
  Point3 acceleration = Point3::Zero();  ///< [mm/s²], constant in between
  WaypointIndex heading_for;
};

/// Plays a toolpath from rest to rest, in any order of times. The toolpath must outlive the player.
class RestToRestPlayer {
 public:
  /// @throws InvalidInput if the toolpath has no motion, or a feed is not positive
  RestToRestPlayer(const Toolpath& toolpath, const MotionLimits& limits);

  double duration() const { return start_s_.back(); }
  /// Before 0 at the first waypoint, after the duration at the last. Logarithmic time.
  RestToRestSample at(double time_s) const;
  /// At 0, `step_s`, 2 `step_s`, ... and at the end.
  /// @throws InvalidInput if the step is not positive
  std::vector<RestToRestSample> sampled(double step_s) const;

 private:
  struct Motion {
    Point3 start = Point3::Zero();
    MotionSegment segment;
    WaypointIndex end;
  };
  std::vector<Motion> motions_;
  std::vector<double> start_s_;  ///< of each motion; one more for the end
};

}  // namespace lamina
