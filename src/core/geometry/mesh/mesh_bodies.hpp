// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {

/// The triangles of a mesh grouped by what hangs together across paired half-edges.
struct MeshBodies {
  std::vector<std::uint32_t> body_of;  ///< per triangle; numbered in order of their first triangle
  std::vector<double> volumes;         ///< per body [mm³], signed; about one common origin
};

MeshBodies findBodies(const Mesh& mesh, const MeshTopology& topology);

/// The bodies that enclose no volume: less than rounding leaves of their area.
std::vector<bool> findSheets(const Mesh& mesh, const MeshBodies& bodies);

/// The bodies that face inwards although they lie inside an even number of others, that is, are no cavities.
std::vector<bool> findInwardBodies(const Mesh& mesh, const MeshBodies& bodies);

}  // namespace lamina
