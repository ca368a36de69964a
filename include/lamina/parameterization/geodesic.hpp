// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/triangle_fans.hpp"

namespace lamina {

/// A vertex from which distances count.
struct GeodesicSource {
  std::uint32_t vertex = 0;
  double start_mm = 0.0;  ///< distance at the vertex itself, at least 0
};

/// Lengths of the shortest ways over a mesh, by fast marching. A wavefront crosses a triangle as the circle
/// around its source, unfolded into the plane of the triangle, so that distances on plane and developable
/// meshes are exact to rounding as long as the shortest way bends at no border and no vertex. Triangles may
/// be obtuse, or without area: a vertex that the front reached by a detour is corrected. (Where very obtuse
/// ones hide each other in a ring the way may be a per cent too long.) No vertex is corrected more than 250
/// times: around slivers whose lengths are mostly rounding, corrections would go on for as good as ever.
///
/// Prepared once per mesh [mm]; queries may be made from several threads and take n log n time.
class GeodesicDistances {
 public:
  /// @throws InvalidMesh if a triangle names a vertex that the mesh does not have
  explicit GeodesicDistances(const Mesh& mesh);
  explicit GeodesicDistances(TriangleFans fans);

  /// @return distance of each vertex [mm], infinity where no way leads
  /// @throws InvalidInput if there is no such vertex
  std::vector<double> from(std::uint32_t source) const;

  /// The least of the distances from several sources, each added to the start of its own. Between sources
  /// that neighbour each other the front starts straight, so that the vertices of a line count as the line.
  /// @throws InvalidInput if there is no such vertex, or a start is negative or not finite
  std::vector<double> from(const std::vector<GeodesicSource>& sources) const;

  /// The vertices of a way along edges that falls as steeply as it can, from a vertex to where it falls no
  /// more.
  /// @param distance  one value per vertex
  std::vector<std::uint32_t> descend(const std::vector<double>& distance, std::uint32_t vertex) const;

  const TriangleFans& fans() const { return fans_; }

 private:
  TriangleFans fans_;
};

}  // namespace lamina
