// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <trajectory_msgs/JointTrajectoryPoint.h>

#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/trajectory/joint_trajectory.hpp"
#include "messages.hpp"

namespace lamina {

/// Of the driven joints, in their order.
std::vector<std::string> jointNames(const KinematicModel& model);

/// Position, velocity and acceleration of the joints in SI; without time.
trajectory_msgs::JointTrajectoryPoint toMessage(const JointState& state,
                                                const std::vector<DrivenJoint>& joints);

/// The joints of a point; without time, process and waypoint. Velocities and accelerations that the point
/// does not report are 0.
/// @param names  of the point's joints, in any order
/// @throws InvalidInput if a joint is missing or unknown, a number is not finite, or there are not as many
///   numbers as names
JointState fromMessage(const trajectory_msgs::JointTrajectoryPoint& point,
                       const std::vector<std::string>& names, const std::vector<DrivenJoint>& joints);

/// Without time.
lamina_msgs::ProcessPoint toMessage(const ProcessSignals& signals);
/// Without stamp and outputs.
lamina_msgs::ProcessState toStateMessage(const ProcessSignals& signals);
ProcessSignals fromMessage(const lamina_msgs::ProcessPoint& point);

}  // namespace lamina
