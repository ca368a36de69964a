// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {

/// A surface divided into parts along its creases: edges at which it bends by 30 degrees or more. Parts that
/// meet in a straight crease, such as the sides of a prism, stay joined, as they unroll together. A closed
/// ring of them is cut. All parts are separated if the whole surface appears to unroll: the function is
/// called only for surfaces that cannot be laid flat. A crease that ends inside a part divides nothing.
struct Creases {
  std::vector<std::uint32_t> part;  ///< part of each triangle; numbered in the order of first triangles
  std::uint32_t parts = 0;
  /// Absolute Gaussian curvature at the vertices between parts, without the surface's border [rad].
  double curvature = 0.0;
  /// Absolute Gaussian curvature at the vertices inside the parts [rad]: 0 if all parts unroll.
  double inside = 0.0;
};

/// @param least_area  parts smaller than this are merged with the neighbour that shares the longest border
///   with them [mm²]
Creases findCreases(const Mesh& surface, const MeshTopology& topology, double least_area);

}  // namespace lamina
