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

/// Names of the driven joints, in order.
std::vector<std::string> jointNames(const KinematicModel& model);

/// Position, velocity and acceleration of the joints in SI; without time.
trajectory_msgs::JointTrajectoryPoint toMessage(const JointState& state,
                                                const std::vector<DrivenJoint>& joints);

/// The joint state of a point; time, process and waypoint are not set. Velocities and accelerations that the
/// point does not state are 0.
/// @param names  names of the point's joints, in any order
/// @throws InvalidInput if a joint is missing or unknown, a number is not finite, or there are not as many
///   numbers as names
JointState fromMessage(const trajectory_msgs::JointTrajectoryPoint& point,
                       const std::vector<std::string>& names, const std::vector<DrivenJoint>& joints);

/// The message of process signals, without time.
lamina_msgs::ProcessPoint toMessage(const ProcessSignals& signals);
/// The message of process signals, without time stamp and outputs.
lamina_msgs::ProcessState toStateMessage(const ProcessSignals& signals);
ProcessSignals fromMessage(const lamina_msgs::ProcessPoint& point);

}  // namespace lamina
