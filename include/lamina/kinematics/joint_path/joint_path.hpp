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

/// What keeps a kinematic model from a waypoint, or from going there as the toolpath asks.
enum class JointFault : std::uint8_t {
  OutOfReach,      ///< no solution at all
  OutOfLimits,     ///< none within the joints' limits
  SelfCollision,   ///< only where links are in each other, as a guard reports (joint_guard.hpp)
  Singular,        ///< nearer to a singularity than the settings allow
  Jump,            ///< no steady way from the waypoint before
  JointUnwinding,  ///< a rotary joint has to be wound back while depositing
  Configuration,   ///< no solution of the configuration that a program states
};

/// "out_of_reach", "out_of_limits", "self_collision", "singular", "jump", "joint_unwinding",
/// "configuration".
const char* toString(JointFault fault);

/// A waypoint that a kinematic model cannot run.
struct FaultyWaypoint {
  WaypointIndex at;
  JointFault fault = JointFault::OutOfReach;
  std::string reason;  ///< joint, value and limit, for people
};

/// The joints of a kinematic model at every waypoint of a toolpath in the order of the motion. A closed path
/// has its waypoint 0 twice: first and last.
struct JointPath {
  std::vector<WaypointIndex> at;
  std::vector<JointValues> values;     ///< as many; of size 0 where there is no solution
  std::vector<FaultyWaypoint> faults;  ///< all of them, in the order of the motion
  double tool_axis_tolerance = 0.0;    ///< by which tool axes may be off what the toolpath asks [rad]
  std::size_t rewinds = 0;             ///< travels on which a rotary joint is wound back by whole turns

  bool isRunnable() const { return faults.empty(); }
};

}  // namespace lamina
