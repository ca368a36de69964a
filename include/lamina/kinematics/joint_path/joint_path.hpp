// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Reasons why a kinematic model cannot reach a waypoint, or cannot run the toolpath's motion to it.
enum class JointFault : std::uint8_t {
  OutOfReach,      ///< there is no inverse solution
  OutOfLimits,     ///< no inverse solution lies within the joints' limits
  SelfCollision,   ///< links collide in every solution, as a guard finds (joint_guard.hpp)
  Singular,        ///< nearer to a singularity than the settings allow
  Jump,            ///< joints cannot move there continuously from the waypoint before
  JointUnwinding,  ///< a rotary joint has to be wound back while depositing
  Configuration,   ///< there is no solution in the configuration that a program states
};

/// "out_of_reach", "out_of_limits", "self_collision", "singular", "jump", "joint_unwinding",
/// "configuration".
const char* toString(JointFault fault);

/// A waypoint that a kinematic model cannot run.
struct FaultyWaypoint {
  WaypointIndex at;
  JointFault fault = JointFault::OutOfReach;
  std::string reason;  ///< explanation for people, with joint, value and limit
};

/// Joint values of a kinematic model at every waypoint of a toolpath, in the order of the motion. Waypoint
/// 0 of a closed path is listed twice, first and last.
struct JointPath {
  std::vector<WaypointIndex> at;
  std::vector<JointValues> values;     ///< at each waypoint of `at`; empty where there is no solution
  std::vector<FaultyWaypoint> faults;  ///< all faulty waypoints, in the order of the motion
  /// Angle by which tool axes may deviate from those of the toolpath [rad].
  double tool_axis_tolerance = 0.0;
  std::size_t rewinds = 0;  ///< number of travels on which a rotary joint is wound back by whole turns

  bool isRunnable() const { return faults.empty(); }
};

}  // namespace lamina
