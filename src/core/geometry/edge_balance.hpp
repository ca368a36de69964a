// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/mesh.hpp"

namespace lamina {

/// Whether the mesh has triangles and every edge has as many half-edges one way as the other: the surface
/// encloses a solid.
bool isBalanced(const Mesh& mesh);

}  // namespace lamina
