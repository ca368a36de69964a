// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/stiffness/stiffness.hpp"

namespace lamina {

/// Writes a VTK file (legacy, binary, an unstructured grid of hexahedra) with the displacement [mm] of the
/// nodes and the stress [MPa] of the elements: von Mises, and the components xx, yy, zz, xy, yz, zx. ParaView
/// opens it.
/// @throws FileError if it cannot be written; an existing file then remains
void writeVtk(const StiffnessResult& result, const std::string& path);

}  // namespace lamina
