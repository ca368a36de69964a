// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// One URDF of a cell file: an arm as its maker describes it, and what stands around it: `nozzle` at the end
/// of its flange, `bed` on the world or on a positioner, a rail under the arm, solid bodies. Axes of rail and
/// positioner are joints external_1, ... in this order; links and joints of the positioner begin with
/// positioner_, and so do its materials. Bed, tool and bodies are seen as they are solid.
///
/// The file is YAML (docs/machines/machines.md); paths in it are over its own folder.
/// @param text  of the file
/// @param path  of it
/// @throws InvalidConfig if anything in it is wrong: all of it is refused, nothing left out
std::string cellDescription(const std::string& text, const std::string& path);

/// Whether the file is a cell file by its name: .yaml or .yml.
bool isCellFile(const std::string& path);

/// Whether the file can be read and has a cell at its top, as a profile of a machine has not.
bool holdsCell(const std::string& path);

/// Description of the machine in a file: a URDF (`readRobotDescription`) or a cell file.
std::string readMachineDescription(const std::string& path);

}  // namespace lamina
