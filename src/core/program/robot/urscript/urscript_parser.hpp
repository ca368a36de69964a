// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "program/robot/reader/robot_parser.hpp"

namespace lamina {

/// The statements of a file in URScript, whose poses are over the robot's base.
/// @throws InvalidProgram naming file and line
std::vector<ReadStatement> parseUrScript(const RobotSourceText& source);

}  // namespace lamina
