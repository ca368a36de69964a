// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/kinematics/machine_choice.hpp"

namespace lamina {

/// Checks that a G-code program for linear axes extrudes within the reach of a machine: the end of each
/// motion that extrudes must lie in the bounding box of its build space. Motions without extrusion, as those
/// of start and end code, are not checked. On a machine with an endless axis (a belt), each linear axis must
/// be within its limits; the endless axis has only a lower limit.
/// @throws FileError if the program cannot be read
/// @throws InvalidProgram naming the line that cannot be read, or if the program extrudes nothing
/// @throws Unreachable naming the line, the position [mm, bed frame] and the machine's limits
void requirePrintable(const std::string& path, const MachineSettings& machine);

/// The machine by which a program is checked, as lines "name: value": its name, the digest of its
/// description, or that it is built in, and its reach [mm] along the axes of its bed. The lines distinguish
/// two machines of one name.
/// @throws FileError, InvalidConfig as `buildSpaceOf`
std::string machineSheet(const MachineSettings& machine);

}  // namespace lamina
