// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

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
    const int last_row = rowOf(high.y());
    const int last_column = columnOf(high.x());
    for (int row = rowOf(low.y()); row <= last_row; ++row)
      for (int column = columnOf(low.x()); column <= last_column; ++column) {
        const std::size_t cell = cellAt(column, row);
        for (std::uint32_t i = begin_[cell]; i < begin_[cell + 1]; ++i)
          visit(edges_[held_[i]].first, edges_[held_[i]].second);
      }
  }

 private:
  using Edge = std::pair<Point2, Point2>;

  template <class Visit>
  void forCells(const Edge& edge, const Visit& visit) const;
  void sortEdges();
  void findInside();
  Point2 centreOf(int column, int row) const {
    return {low_.x() + (column + 0.5) * cell_mm_, low_.y() + (row + 0.5) * cell_mm_};
  }
  int columnOf(double x) const { return clamped((x - low_.x()) / cell_mm_, columns_); }
  int rowOf(double y) const { return clamped((y - low_.y()) / cell_mm_, rows_); }
  static int clamped(double position, int count);
  std::size_t cellAt(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  double reach_;
  std::vector<Edge> edges_;
  Point2 low_ = Point2::Zero();
  double cell_mm_ = 1.0;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::uint32_t> begin_{0, 0};  ///< where the edges of each cell begin, and an end
  std::vector<std::uint32_t> held_;         ///< edges, cell by cell
  std::vector<bool> is_inside_;             ///< the middle of each cell
};

}  // namespace lamina
