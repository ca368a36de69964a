// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {

/// The unpaired half-edges of a mesh, chained into closed loops along its borders, in the direction of their
/// triangles. A loop may pass a vertex more than once. No triangle of the mesh may have a vertex twice.
std::vector<std::vector<HalfEdge>> findBorderLoops(const MeshTopology& topology);

}  // namespace lamina
