// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/self_intersections.hpp"

namespace lamina {

/// Which way the triangles of a mesh face.
enum class MeshOrientation {
  Outward,       ///< neighbours agree, and every body that is no cavity faces outwards
  Inward,        ///< neighbours agree, and the mesh as a whole is inside out
  Mixed,         ///< neighbours agree, but some bodies face inwards
  Inconsistent,  ///< neighbours disagree
};

/// "outward", "inward", "mixed", "inconsistent"
const char* toString(MeshOrientation orientation);

/// What there is to know about a mesh before it is printed. Edges count only between two different vertices.
struct MeshReport {
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  Box3 box;                 ///< [mm]
  double volume_mm3 = 0.0;  ///< signed; of an open mesh, what the surface and the first vertex enclose
  double area_mm2 = 0.0;
  bool is_closed = false;                ///< every edge has as many half-edges one way as the other
  std::size_t border_edges = 0;          ///< edges where an odd number of triangles meet
  std::size_t border_loops = 0;          ///< closed lines that they form
  std::size_t nonmanifold_edges = 0;     ///< edges where more than two triangles meet
  std::size_t inconsistent_edges = 0;    ///< edges of an even number that do not run half each way
  std::size_t degenerate_triangles = 0;  ///< that name a vertex twice
  std::size_t flat_triangles = 0;        ///< without area between three different vertices
  std::size_t bodies = 0;                ///< parts that hang together across edges
  MeshOrientation orientation = MeshOrientation::Outward;
  SelfIntersections self_intersections;
};

/// @throws Cancelled if `progress` is cancelled
MeshReport reportMesh(const Mesh& mesh, Progress& progress);

}  // namespace lamina
