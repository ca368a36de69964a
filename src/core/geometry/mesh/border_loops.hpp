// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {

/// The single half-edges of a mesh, chained into closed loops that follow the surface along its borders. A
/// loop may pass a vertex more than once. The mesh must have no triangle that names a vertex twice.
std::vector<std::vector<HalfEdge>> findBorderLoops(const MeshTopology& topology);

}  // namespace lamina
