// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/skin_samples.hpp"

#include <limits>

namespace lamina {

std::uint32_t nodeBelow(const CellGraph& cells, const Point3& place, const Point3& normal) {
  const double cell = cells.frame().voxel_mm;
  const Point3 inner = place - 0.25 * cell * normal;
  const std::uint32_t there = cells.nodeAt(inner);
  if (there != CellGraph::kNone) return there;
  const Point3 at = (inner - cells.frame().corner) / cell;
  std::uint32_t nearest = CellGraph::kNone;
  double least = std::numeric_limits<double>::infinity();
  for (int near = 0; near < 27; ++near) {
    const auto [first, last] =
        cells.nodesIn({static_cast<int>(at.x()) + near % 3 - 1, static_cast<int>(at.y()) + near / 3 % 3 - 1,
                       static_cast<int>(at.z()) + near / 9 - 1});
    for (std::uint32_t node = first; node < last; ++node) {
      const double squared = (cells.middle(node) - inner).squaredNorm();
      if (squared >= least) continue;
      least = squared;
      nearest = node;
    }
  }
  return nearest;
}

}  // namespace lamina
