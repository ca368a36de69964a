// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "program/robot/reader/robot_parser.hpp"

namespace lamina {

/// The statements of a listing of Fanuc's teach pendant language.
/// @throws InvalidProgram naming file and line
std::vector<ReadStatement> parseFanuc(const RobotSourceText& source);

}  // namespace lamina
