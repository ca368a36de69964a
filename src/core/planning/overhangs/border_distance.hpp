// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/spatial/edge_grid.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Distance of points from the borders of regions, by a grid of their edges. The cost of a look-up depends on
/// the number of edges within the reach only.
class BorderDistance {
 public:
  /// @param reach_mm  greatest distance that is measured; positive
  BorderDistance(const Regions& regions, double reach_mm);

  /// Distance to the nearest border [mm], negative inside, and clamped to the reach either way. Without
  /// regions it is the reach.
  double at(const Point2& point) const;

  /// Whether the point lies in the regions; on a border either result is possible.
  bool isInside(const Point2& point) const;

  /// Calls visit(a, b) for each edge that may touch a box, for some edges more than once.
  template <class Visit>
  void visitEdges(const Point2& low, const Point2& high, const Visit& visit) const {
    grid_.forEdgesNear({low, high}, [&](std::size_t e) { visit(edges_[e].first, edges_[e].second); });
  }

 private:
  using Edge = std::pair<Point2, Point2>;

  void findInside();

  double reach_;
  std::vector<Edge> edges_;
  Box2 box_;  ///< of the grid
  EdgeGrid grid_;
  std::vector<bool> is_inside_;  ///< the middle of each cell, row by row
};

}  // namespace lamina
