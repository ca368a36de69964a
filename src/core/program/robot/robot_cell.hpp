// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "lamina/kinematics/arm/arm_cell.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "program/robot/robot_statement.hpp"

namespace lamina {

/// The cell of an arm over the frame in which its controller counts: the link `base` of its description where
/// there is one, which robots with a bed of their own to stand on have beside the root.
ArmCell controllerCell(const KinematicModel& arm);

/// How a controller counts joints: each with a sign and a zero, and joint 3 perhaps with a share of joint 2,
/// as one that counts the forearm from level does.
struct ControllerMap {
  std::array<double, 6> signs = {1, 1, 1, 1, 1, 1};
  std::array<double, 6> zeros_deg{};
  double joint_3_from_2 = 0.0;

  bool isPlain() const;
};

/// @throws InvalidConfig if the kinematic model is no six-axis arm
ControllerJoints controllerJoints(const ControllerMap& map, const KinematicModel& arm,
                                  const JointValues& values);

/// The other way round; external axes that are not given stand at zero.
JointValues armJoints(const ControllerMap& map, const KinematicModel& arm, const ControllerJoints& joints);

}  // namespace lamina
