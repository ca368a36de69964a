// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/robot/robot_program_settings.hpp"
#include "lamina/program/robot/robot_writer.hpp"

namespace lamina {

/// The settings, with those left at their defaults taken from what an arm's cell file states of its
/// controller.
/// @throws InvalidConfig if the controller runs programs in another language, or a setting differs from what
///   the cell file states
RobotProgramSettings withArmController(RobotProgramSettings settings, RobotLanguage language,
                                       const KinematicModel& arm);

}  // namespace lamina
