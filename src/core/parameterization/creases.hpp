// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {

/// A surface divided along its creases: edges at which it bends by 30 degrees or more. What unrolls together
/// stays together: parts that meet in a straight crease, as the sides of a prism do, but never all around;
/// if the whole surface seems to, all parts are apart: it is asked about since it does not lie flat. A crease
/// that ends inside a part divides nothing.
struct Creases {
  std::vector<std::uint32_t> part;  ///< of each triangle; numbered in the order of their first triangles
  std::uint32_t parts = 0;
  /// Absolute Gaussian curvature at the vertices between parts, without the surface's border [rad].
  double curvature = 0.0;
  /// The same inside the parts: 0 if they unroll.
  double inside = 0.0;
};

/// @param least_area  smaller parts are counted to the neighbour with which they share the longest border
///                    [mm²]
Creases findCreases(const Mesh& surface, const MeshTopology& topology, double least_area);

}  // namespace lamina
