// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/geometry/mesh_io/mesh_reader.hpp"

namespace lamina {

/// Refuses a unit other than millimetres for a file that states its own (3MF and STEP by their content, SVG
/// by its name) and for a parametric part, where the unit would change nothing.
/// @param option  name of the option that gives the unit, for the message: "input.unit"
/// @throws InvalidConfig naming the option, the unit and the file
/// @throws FileError if the file cannot be read
void requireUnitUnstated(const std::string& path, LengthUnit unit, const std::string& option);

}  // namespace lamina
