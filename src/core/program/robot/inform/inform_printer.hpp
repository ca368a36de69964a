// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "program/robot/writer/robot_printer.hpp"

namespace lamina {

/// Jobs (.jbi) in the language of Yaskawa's controllers.
RobotDialect informDialect(const RobotProgramSettings& settings);

}  // namespace lamina
