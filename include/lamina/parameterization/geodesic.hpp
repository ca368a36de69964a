// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/triangle_fans.hpp"

namespace lamina {

/// A vertex from which distances are measured.
struct GeodesicSource {
  std::uint32_t vertex = 0;
  double start_mm = 0.0;  ///< distance at the vertex itself, at least 0
};

/// Lengths of the shortest paths over a mesh, by fast marching. A wavefront crosses a triangle as the circle
/// around its source, unfolded into the plane of the triangle, so that distances on plane and developable
/// meshes are exact to rounding as long as the shortest path bends at no border and no vertex. Triangles may
/// be obtuse, or without area: a vertex that the front reached by a detour is corrected. (Where very obtuse
/// triangles hide each other in a ring, a path may be a per cent too long.) A vertex is corrected at most 250
/// times, as corrections would hardly end around slivers whose lengths are mostly rounding errors.
///
/// An object is prepared once for a mesh [mm]. Queries may be made from several threads and take n log n
/// time.
class GeodesicDistances {
 public:
  /// @throws InvalidMesh if a triangle names a vertex that the mesh does not have
  explicit GeodesicDistances(const Mesh& mesh);
  explicit GeodesicDistances(TriangleFans fans);

  /// @return distance of each vertex [mm], infinity if no path leads to it
  /// @throws InvalidInput if there is no such vertex
  std::vector<double> from(std::uint32_t source) const;

  /// For each vertex, the least over several sources of the distance from the source plus its `start_mm`.
  /// Between neighbouring sources the front starts straight, so that the vertices of a line act as the whole
  /// line.
  /// @throws InvalidInput if there is no such vertex, or a start is negative or not finite
  std::vector<double> from(const std::vector<GeodesicSource>& sources) const;

  /// The vertices of a path along edges on which `distance` falls most steeply, from a vertex to one where it
  /// no longer falls.
  /// @param distance  one value for each vertex
  std::vector<std::uint32_t> descend(const std::vector<double>& distance, std::uint32_t vertex) const;

  const TriangleFans& fans() const { return fans_; }

 private:
  TriangleFans fans_;
};

}  // namespace lamina
