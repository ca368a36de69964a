// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "lamina/kinematics/arm/arm_cell.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/robot/robot_program_settings.hpp"
#include "program/robot/robot_statement.hpp"

namespace lamina {

/// The cell of an arm over the frame in which its controller counts positions: the link `base` of its
/// description, or the root if there is no such link or joints move it. Descriptions whose root is not the
/// robot's base have a link `base`. If an external axis carries the bed, the cell is that of `armCell`.
ArmCell controllerCell(const KinematicModel& arm);

/// How a controller counts joints: each with a sign and a zero, and joint 3 possibly with a share of joint 2,
/// as in controllers that count the angle of the forearm from level.
struct ControllerMap {
  std::array<double, 6> signs = {1, 1, 1, 1, 1, 1};
  std::array<double, 6> zeros_deg{};
  double joint_3_from_2 = 0.0;

  bool isPlain() const;
};

/// Joint values of the model, as the controller counts them.
/// @throws InvalidConfig if the kinematic model is no six-axis arm
ControllerJoints controllerJoints(const ControllerMap& map, const KinematicModel& arm,
                                  const JointValues& values);

/// The inverse of `controllerJoints`; missing values of external axes are taken as zero.
JointValues armJoints(const ControllerMap& map, const KinematicModel& arm, const ControllerJoints& joints);

/// The kind of controller that runs programs of a language, as `cell.controller` names it.
const char* controllerKind(RobotLanguage language);

/// Checks that a program suits the controller that an arm's cell file states, if any: by the language, and by
/// how the program counts joints.
/// @throws InvalidConfig as `requireControllerKind`
/// @throws InvalidProgram if the program counts joints otherwise
void requireController(RobotLanguage language, const ControllerMap& map, const KinematicModel& arm);

}  // namespace lamina
