// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/stated_motion.hpp"
#include "lamina/trajectory/timed_path.hpp"
#include "lamina/verification/collision/joint_clearance.hpp"

namespace lamina {

/// What stands in the way of a machine on its way beside the part.
struct PassageFault {
  std::size_t index = 0;  ///< of the value
  JointFault fault = JointFault::OutOfReach;
  std::string reason;
};

/// A way beside the part, as a controller leads the joints.
struct RunPassage {
  JointPassage joints;             ///< `before` counts the waypoints of the run
  std::vector<std::size_t> lines;  ///< of the program, for the way to each of the values
  std::vector<double> feeds;       ///< of the tip on the way to each; 0 where joints move to it [mm/s]
  std::vector<PassageFault> faults;
};

/// The passages of a program, each from the waypoint before it, or from the first joints stated, up to the
/// waypoint behind it. Joint moves go from joints to joints; straight ones are led as along the part
/// (`alongStraightMoves`). Faults are limits, places out of reach, and joints that turn by more than
/// `joints.max_turn_deg` from one place of a straight way to the next. `before` counts the stated waypoints.
std::vector<RunPassage> ledPassages(const KinematicModel& model, const StatedMotion& motion,
                                    const JointPathSettings& settings);

/// Time of the ways of all passages [s]: each goes from rest to rest, a straight one at its feed within
/// `motion.travel_acceleration_mm_s2` or as slowly as joints need, one of the joints at the greatest speeds
/// of these with the ramp of `trajectory.joint_ramp_s`. A place that is not reached takes none.
double passageTime(const std::vector<RunPassage>& passages, const KinematicModel& model,
                   const TimingSettings& settings);

/// What of the way to the first waypoint of an arm's program is not known, in one sentence: it begins
/// wherever the arm stands.
std::string unknownWay(const StatedMotion& motion);

}  // namespace lamina
