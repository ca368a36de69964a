// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/mesh/subdivision.hpp"

namespace lamina {

/// A plane that a shell keeps to one side of: normal · p <= offset.
struct ShellBound {
  Point3 normal = Point3::UnitZ();  ///< of unit length
  double offset_mm = 0.0;
};

/// The plane of a face beside an open surface, at a vertex of its rim.
struct RimWall {
  std::uint32_t vertex = 0;
  Point3 normal = Point3::UnitX();  ///< of unit length
};

/// An open surface to be propagated, towards where it faces, and what stands beside its rim.
struct ShellSource {
  Mesh surface;
  std::vector<RimWall> walls;
};

/// How a vertex of a surface moves when the surface is propagated.
struct VertexMotion {
  Point3 per_mm = Point3::Zero();   ///< path per millimetre of propagation; may be longer than 1
  Point3 normal = Point3::UnitZ();  ///< mean of the surface's normals, weighted by angles, of unit length
  int planes = 0;                   ///< 1 on a smooth surface, 2 on an edge, 3 at a corner
  double exactness = 1.0;           ///< the least advance of an incident triangle's plane per mm, not above 1
};

/// Motions by which every triangle's plane moves forward by the distance propagated, where that can be solved
/// [Guacheta2021, listing A.6]: the shortest solution of N s = 1 over the normals of the triangles at a
/// vertex, weighted by their angles. Directions in which the normals differ by less than a tenth of what they
/// have in common (about 12 degrees between two faces) do not bend the path; no path is longer than four
/// times the distance. As far as these conditions can be solved, too, a vertex on the bound's plane moves
/// within that plane (spec `Planar == 1`), and a vertex of the rim moves within the walls beside it; walls
/// that go on from the surface within 40 degrees do not count.
///
/// @return for the vertices of the subdivision of `source.surface`: those in between move as the middles of
///         their edges do, so that facets stay plane and move as if they were whole
std::vector<VertexMotion> vertexMotions(const ShellSource& source, const Subdivision& subdivision,
                                        const std::optional<ShellBound>& bound);

}  // namespace lamina
