// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/subdivision.hpp"

namespace lamina {

/// A half-space within which shells stay: the points p with normal · p <= offset.
struct ShellBound {
  Point3 normal = Point3::UnitZ();  ///< of unit length
  double offset_mm = 0.0;
};

/// A face that adjoins an open surface at a vertex of its rim.
struct RimWall {
  std::uint32_t vertex = 0;         ///< index in the surface
  Point3 normal = Point3::UnitX();  ///< normal of the face, of unit length
};

/// An open surface that is to be propagated to the side that it faces, and the faces that adjoin its rim.
struct ShellSource {
  Mesh surface;
  std::vector<RimWall> walls;
};

/// How a vertex of a surface moves when the surface is propagated.
struct VertexMotion {
  Point3 per_mm = Point3::Zero();   ///< displacement per millimetre of propagation; may be longer than 1
  Point3 normal = Point3::UnitZ();  ///< mean normal of the triangles, weighted by angles, of unit length
  int planes = 0;                   ///< 1 on a smooth surface, 2 on an edge, 3 at a corner
  double exactness = 1.0;  ///< least advance of a plane of the triangles at the vertex, per mm; at most 1
};

/// The motions of vertices by which the plane of every triangle advances by the distance of propagation, as
/// far as a solution exists [Guacheta2021, listing A.6]. A motion is the shortest solution s of N s = 1, with
/// the normals of the triangles at the vertex as the rows of N, weighted by their angles. Directions in which
/// the normals differ by less than a tenth of their common direction (about 12 degrees between two faces) do
/// not bend the path, and no path is longer than four times the distance. If the conditions can still be
/// solved, a vertex in the bound's plane moves within that plane (spec `Planar == 1`), and a vertex of the
/// rim moves within the walls beside it. Walls that continue the surface within 40 degrees are ignored.
///
/// @return a motion for each vertex of the subdivision of `source.surface`. Vertices that the subdivision has
///         added move as the middles of their edges do, so that facets stay plane.
std::vector<VertexMotion> vertexMotions(const ShellSource& source, const Subdivision& subdivision,
                                        const std::optional<ShellBound>& bound);

}  // namespace lamina
