// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "lamina/slicing/curved/vertex_motion.hpp"
#include "lamina/slicing/curved/vertex_neighbours.hpp"

namespace lamina {

/// A surface under way, as far as merging needs to know it.
struct MovingSurface {
  const Mesh& surface;
  const VertexNeighbours& neighbours;
  const std::vector<VertexMotion>& motions;
  const std::vector<double>& collapse_mm;

  Point3 at(std::uint32_t vertex, double offset_mm) const {
    return surface.vertices[vertex] + offset_mm * motions[vertex].per_mm;
  }
};

/// Where the vertices of a surface are at an offset at which some of them have collapsed.
struct MergedVertices {
  static constexpr std::uint32_t kGone = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::uint32_t> root;  ///< the vertex whose place each one takes; `kGone` if nothing lives near
  std::vector<Point3> place;        ///< of each root [mm]
  std::vector<char> is_stopped;     ///< whether a root stands where its neighbours collapse, not on its path
};

/// Living vertices go their way. Collapsed ones are merged into what is left around them: first, beside an
/// edge that living vertices run along, into that edge (on facets the shell stays exact); then, beside living
/// ones, they stop where the edges to those collapse at this very offset, which is on the crease that has
/// come about; the others join the nearest of either, counted in edges.
MergedVertices mergeCollapsed(const MovingSurface& moving, double offset_mm);

}  // namespace lamina
