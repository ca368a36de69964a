// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "lamina/slicing/curved/vertex_motion.hpp"
#include "lamina/slicing/curved/vertex_neighbours.hpp"

namespace lamina {

/// A surface whose vertices move with the offset, as `mergeCollapsed` needs it.
struct MovingSurface {
  const Mesh& surface;
  const VertexNeighbours& neighbours;
  const std::vector<VertexMotion>& motions;
  const std::vector<double>& collapse_mm;

  Point3 at(std::uint32_t vertex, double offset_mm) const {
    return surface.vertices[vertex] + offset_mm * motions[vertex].per_mm;
  }
};

/// Positions of the vertices of a surface at an offset at which some of them have collapsed.
struct MergedVertices {
  static constexpr std::uint32_t kGone = std::numeric_limits<std::uint32_t>::max();

  /// For each vertex the vertex whose position it takes; `kGone` if no vertex near it is left.
  std::vector<std::uint32_t> root;
  std::vector<Point3> place;  ///< position of each root [mm]
  /// Whether a root stands where its neighbours collapse instead of on its own path.
  std::vector<char> is_stopped;
};

/// Moves the vertices of a surface by an offset and merges those that have collapsed into what is left around
/// them. Vertices that have not collapsed (living ones) move on their paths. A collapsed vertex beside an
/// edge between living ones is merged into that edge, so that the shell stays exact on facets. A collapsed
/// vertex beside living ones otherwise stops where the edges to them collapse at this offset, which is on the
/// crease that has formed. All others join the nearest vertex of either kind, counted in edges.
MergedVertices mergeCollapsed(const MovingSurface& moving, double offset_mm);

}  // namespace lamina
