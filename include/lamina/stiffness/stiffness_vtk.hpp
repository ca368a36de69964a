// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/stiffness/stiffness.hpp"

namespace lamina {

/// Writes elements, displacement [mm] of the nodes, and stress [MPa] of the elements (von Mises, and the six
/// components xx, yy, zz, xy, yz, zx) as a VTK file: legacy binary, an unstructured grid of hexahedra, which
/// ParaView opens.
/// @throws FileError if it cannot be written; then what was there stays
void writeVtk(const StiffnessResult& result, const std::string& path);

}  // namespace lamina
