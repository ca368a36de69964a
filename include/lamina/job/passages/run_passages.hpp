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

/// A fault of a machine on a motion beside the part.
struct PassageFault {
  std::size_t index = 0;  ///< index of the value
  JointFault fault = JointFault::OutOfReach;
  std::string reason;
};

/// A motion beside the part, with the joints as a controller moves them.
struct RunPassage {
  JointPassage joints;             ///< `before` counts the waypoints of the run
  std::vector<std::size_t> lines;  ///< lines of the program, for the motion to each of the values
  std::vector<double> feeds;       ///< feeds of the tip on the motion to each value [mm/s]; 0 for joint moves
  std::vector<PassageFault> faults;
};

/// The passages of a program. Each begins at the previous waypoint, or at the first stated joints, and ends
/// at the next waypoint. Joint moves are interpolated in the joints, straight moves as along the part
/// (`alongStraightMoves`). Faults are limits, poses out of reach, and joints that turn by more than
/// `joints.max_turn_deg` between two neighbouring points of a straight move. `before` counts the stated
/// waypoints.
std::vector<RunPassage> ledPassages(const KinematicModel& model, const StatedMotion& motion,
                                    const JointPathSettings& settings);

/// Time of all passages [s]. Each move goes from rest to rest. A straight move has its feed within
/// `motion.travel_acceleration_mm_s2`, or is as slow as the joints require. A joint move has the greatest
/// speeds of the joints, with the ramp of `trajectory.joint_ramp_s`. A move to a pose that is not reached
/// takes no time.
double passageTime(const std::vector<RunPassage>& passages, const KinematicModel& model,
                   const TimingSettings& settings);

/// A sentence on the unknown part of the motion to the first waypoint of an arm's program, which begins
/// wherever the arm stands. Empty for other programs.
std::string unknownWay(const StatedMotion& motion);

}  // namespace lamina
