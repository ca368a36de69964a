// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/robot/robot_program_settings.hpp"
#include "lamina/program/robot/robot_writer.hpp"

namespace lamina {

/// The settings with what the cell file of an arm states of its controller, where they leave it at their
/// defaults.
/// @throws InvalidConfig if the controller runs programs in another language, or a setting differs from it
RobotProgramSettings withArmController(RobotProgramSettings settings, RobotLanguage language,
                                       const KinematicModel& arm);

}  // namespace lamina
