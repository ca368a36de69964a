// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh.hpp"

namespace lamina {

/// A vertex from which distances count.
struct GeodesicSource {
  std::uint32_t vertex = 0;
  double start_mm = 0.0;  ///< distance at the vertex itself, at least 0
};

/// Lengths of the shortest ways over a mesh, by fast marching. A wavefront crosses a triangle as the circle
/// around its source, unfolded into the plane of the triangle, so that distances on plane and developable
/// meshes are exact to rounding as long as the shortest way bends at no border and no vertex. Triangles may
/// be obtuse: a vertex that the front reached too late is corrected. Those without area are only run along.
///
/// Prepared once per mesh [mm]; queries may be made from several threads and take n log n time.
class GeodesicDistances {
 public:
  /// @throws InvalidMesh if a triangle names a vertex that the mesh does not have
  explicit GeodesicDistances(const Mesh& mesh);

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

 private:
  friend class GeodesicMarch;

  /// A triangle seen from one of its corners, to cross either of the sides that start there.
  struct Corner {
    std::uint32_t next = 0;      // vertices counter-clockwise after the corner
    std::uint32_t previous = 0;  //
    double to_next = 0.0;        // [mm]
    double to_previous = 0.0;    // [mm]
    double dot = 0.0;            // of the vectors to both [mm²]
    double cross = 0.0;          // twice the area [mm²]
  };

  std::vector<std::uint32_t> first_;  // of each vertex in corners_, and the end
  std::vector<Corner> corners_;
};

}  // namespace lamina
