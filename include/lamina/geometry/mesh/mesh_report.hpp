// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/self_intersections.hpp"

namespace lamina {

/// Direction in which the triangles of a mesh face.
enum class MeshOrientation {
  Outward,       ///< neighbours agree, and every body that is no cavity faces outwards
  Inward,        ///< neighbours agree, and the mesh as a whole is inside out
  Mixed,         ///< neighbours agree, but some bodies face inwards
  Inconsistent,  ///< neighbours disagree
};

/// "outward", "inward", "mixed", "inconsistent"
const char* toString(MeshOrientation orientation);

/// Report on a mesh before it is printed. Only edges between two different vertices count.
struct MeshReport {
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  Box3 box;  ///< [mm]
  /// Signed volume; of an open mesh, the volume of the cone from its first vertex over the surface.
  double volume_mm3 = 0.0;
  double area_mm2 = 0.0;
  bool is_closed = false;             ///< every edge has equally many half-edges in both directions
  std::size_t border_edges = 0;       ///< edges where an odd number of triangles meet
  std::size_t border_loops = 0;       ///< number of closed lines that the border edges form
  std::size_t nonmanifold_edges = 0;  ///< edges where more than two triangles meet
  /// Edges where an even number of triangles meet, but not half of them in each direction.
  std::size_t inconsistent_edges = 0;
  std::size_t degenerate_triangles = 0;  ///< triangles that have the same vertex twice
  std::size_t flat_triangles = 0;        ///< triangles without area between three different vertices
  std::size_t bodies = 0;                ///< parts that are connected across edges
  MeshOrientation orientation = MeshOrientation::Outward;
  SelfIntersections self_intersections;
};

/// Examines a mesh.
/// @throws Cancelled if `progress` is cancelled
MeshReport reportMesh(const Mesh& mesh, Progress& progress);

}  // namespace lamina
