// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {

/// A point where triangle `a` passes through triangle `b`; nothing if they do not cross (see
/// `findSelfIntersections`). The topology of the mesh is used to tell passing through an edge from touching
/// it.
std::optional<Point3> findCrossing(const Mesh& mesh, const MeshTopology& topology, std::uint32_t a,
                                   std::uint32_t b);

}  // namespace lamina
