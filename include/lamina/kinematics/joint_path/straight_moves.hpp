// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/joint_path/divided_joint_path.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Adds joint values between stated ones, for a controller that leads the nozzle straight from waypoint to
/// waypoint. Motions are divided as by `planDividedJointPath`. Each waypoint in between gets the inverse
/// solution nearest to the joint values of the waypoint before; external axes move at constant speed. Motions
/// from or to a waypoint without joint values are not divided.
/// @param stated  joints at the waypoints of `toolpath`, with their faults
/// @param toolpath  [bed frame]
/// @return the path with the stated joints and faults, and a fault `out_of_reach` at each waypoint in between
///   that is out of reach
DividedJointPath alongStraightMoves(Toolpath toolpath, JointPath stated, const KinematicModel& model,
                                    const JointPathSettings& settings);

}  // namespace lamina
