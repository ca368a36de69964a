// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/joint_path/divided_joint_path.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Joints between stated ones where a controller leads the nozzle straight from waypoint to waypoint. Motions
/// are divided as `planDividedJointPath` does; at the waypoints in between the joints are those of the
/// inverse solution next to the waypoint before, and external axes move steadily. Motions from or to a
/// waypoint without joints stay whole.
/// @param stated  joints at the waypoints of `toolpath`, with their faults
/// @param toolpath  [bed frame]
/// @return with the same joints and faults at the waypoints stated, and a fault `out_of_reach` in front of
///   them where a motion leaves the reach between two
DividedJointPath alongStraightMoves(Toolpath toolpath, JointPath stated, const KinematicModel& model,
                                    const JointPathSettings& settings);

}  // namespace lamina
