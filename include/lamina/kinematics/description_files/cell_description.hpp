// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// The URDF of the cell in a cell file: the manufacturer's description of an arm, with `nozzle` at the end of
/// the flange, `bed` on the world or on a positioner, a rail below the arm, and solid bodies. The axes of
/// rail and positioner become joints external_1, external_2, ... in this order. Names of the positioner's
/// links, joints and materials begin with positioner_. Bed, tool and bodies have the same shape for display
/// as for collision.
///
/// The file is YAML (docs/machines/machines.md); paths in it are relative to its own folder.
/// @param text  of the file
/// @param path  of the file
/// @throws InvalidConfig if anything in the file is wrong; nothing is skipped
std::string cellDescription(const std::string& text, const std::string& path);

/// Whether the file is a cell file by its name: .yaml or .yml.
bool isCellFile(const std::string& path);

/// Whether the file can be read and has a cell at its top level; a profile of a machine has none.
bool holdsCell(const std::string& path);

/// Description (URDF) of the machine in a file, which is a URDF (`readRobotDescription`) or a cell file.
/// @throws as `readRobotDescription`, `cellDescription`
std::string readMachineDescription(const std::string& path);

}  // namespace lamina
