// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "program/robot/writer/robot_printer.hpp"

namespace lamina {

/// The language of Universal Robots' controllers: .script, poses over the robot's base in metres and radians.
RobotDialect urScriptDialect(const RobotProgramSettings& settings);

}  // namespace lamina
