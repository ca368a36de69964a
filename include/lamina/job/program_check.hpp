// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/kinematics/cartesian/cartesian_machine_settings.hpp"

namespace lamina {

/// Reads a G-code program as a machine of linear axes would, and requires that it extrudes within that
/// machine's reach. What it does while nothing is extruded, as start and end code do, is not judged.
/// @throws FileError if it cannot be read
/// @throws InvalidProgram naming the line that cannot be read, or if it extrudes nothing
/// @throws Unreachable naming the line, the place [mm, bed] and the machine's limits
void requirePrintable(const std::string& path, const MachineSettings& machine);

}  // namespace lamina
