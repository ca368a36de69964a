// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lamina/kinematics/arm/arm_cell.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/robot/robot_program_settings.hpp"
#include "program/external_entries.hpp"
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
  /// External axes in the order of the controller; empty for the joints' order, sense and zero.
  std::vector<ExternalEntry> external;

  bool isPlain() const;  ///< but for external axes
};

/// The axes of `robot_program.external_axes`, as "external_1=e2, external_2=-e1+90", e1 first.
/// @throws InvalidConfig as `externalEntries`, or if they are not e1, e2, ... without a gap
std::vector<ExternalEntry> robotExternals(const std::string& text);

/// What a map states of external axes that an arm does not have, or not of those that it has; empty if
/// nothing.
std::string externalMismatch(const ControllerMap& map, const KinematicModel& arm);

/// Values of an arm's external axes as its controller counts them, in its order [mm, deg].
std::vector<double> controllerAxes(const ControllerMap& map, const KinematicModel& arm,
                                   const JointValues& values);

/// Kinds of an arm's external axes in the order of the controller.
std::vector<JointKind> controllerAxisKinds(const ControllerMap& map, const KinematicModel& arm);

/// The inverse of `controllerAxes`: joint values with the external ones replaced; nothing if there are too
/// few.
std::optional<JointValues> withControllerAxes(const ControllerMap& map, const KinematicModel& arm,
                                              const JointValues& values, const std::vector<double>& axes);

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
