// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {

/// The triangles of a mesh, grouped into bodies that are connected across paired half-edges.
struct MeshBodies {
  std::vector<std::uint32_t> body_of;  ///< body of each triangle; numbered in the order of first triangles
  std::vector<double> volumes;         ///< signed volume of each body [mm³]
};

MeshBodies findBodies(const Mesh& mesh, const MeshTopology& topology);

/// For each body whether it encloses no volume, to within rounding.
std::vector<bool> findSheets(const Mesh& mesh, const MeshBodies& bodies);

/// For each body whether it faces inwards although it lies inside an even number of others and so is no
/// cavity.
std::vector<bool> findInwardBodies(const Mesh& mesh, const MeshBodies& bodies);

}  // namespace lamina
