// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "program/robot/writer/robot_printer.hpp"

namespace lamina {

/// The language of KUKA's controllers: .src, with .dat where points stand in a data file.
RobotDialect krlDialect(const RobotProgramSettings& settings);

}  // namespace lamina
