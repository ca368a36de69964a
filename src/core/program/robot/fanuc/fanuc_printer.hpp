// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "program/robot/writer/robot_printer.hpp"

namespace lamina {

/// Listings (.ls) of Fanuc's teach pendant language.
RobotDialect fanucDialect(const RobotProgramSettings& settings);

}  // namespace lamina
