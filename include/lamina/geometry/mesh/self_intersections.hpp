// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Where a surface passes through itself.
struct SelfIntersections {
  std::size_t pairs = 0;      ///< number of pairs of triangles that pass through each other
  std::vector<Point3> where;  ///< a point [mm] of each of the first ten pairs
};

/// Finds the pairs of triangles that pass through each other: an edge of one passes from one side of the
/// surface to the other, through the inside or a side of the other triangle. Signs are decided with a bound
/// on the rounding error: what cannot be distinguished from touching counts as touching, and touching (a
/// vertex or an edge on a face, faces on each other, an edge through a vertex) is no intersection. Triangles
/// with a common edge are not compared. Time is n log n in the number of triangles; the result is the same
/// for any number of threads.
///
/// @throws Cancelled if `progress` is cancelled
SelfIntersections findSelfIntersections(const Mesh& mesh, Progress& progress);

}  // namespace lamina
