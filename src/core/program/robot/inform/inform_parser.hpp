// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "program/robot/reader/robot_parser.hpp"

namespace lamina {

/// The statements of a job in INFORM. Joints in pulses can be converted to degrees only if the note `pulses`
/// states the pulses of each joint.
/// @throws InvalidProgram naming file and line
std::vector<ReadStatement> parseInform(const RobotSourceText& source);

}  // namespace lamina
