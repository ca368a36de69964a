// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Finds edges near a line by a grid with about as many cells as edges; each cell holds the edges that cross
/// it.
class EdgeGrid {
 public:
  EdgeGrid() = default;
  /// @param edges          pairs of end points [mm]
  /// @param fewest_across  least number of cells along the longer side
  explicit EdgeGrid(const std::vector<std::pair<Point2, Point2>>& edges, double fewest_across = 0.0);
  /// Makes a grid with cells of a given size over a box that contains the edges and is not empty.
  EdgeGrid(const std::vector<std::pair<Point2, Point2>>& edges, const Box2& box, double cell_mm);

  bool isEmpty() const { return first_.size() < 2; }
  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  /// Column of a position; positions outside the grid belong to the outermost columns.
  std::size_t columnOf(double x) const { return index(x, low_.x(), columns_); }
  std::size_t rowOf(double y) const { return index(y, low_.y(), rows_); }

  /// Calls `visit(edge)` with the index of each edge of a cell, until it returns false.
  /// @return whether all were visited
  template <class Visit>
  bool forEdgesIn(std::size_t column, std::size_t row, const Visit& visit) const {
    const std::size_t cell = row * columns_ + column;
    for (std::size_t i = first_[cell]; i < first_[cell + 1]; ++i)
      if (!visit(edges_[i])) return false;
    return true;
  }

  /// Calls `visit(edge)` for all edges that may touch a box, for some of them more than once.
  template <class Visit>
  void forEdgesNear(const Box2& box, const Visit& visit) const {
    if (isEmpty()) return;
    const std::size_t last_row = rowOf(box.high.y());
    const std::size_t last_column = columnOf(box.high.x());
    for (std::size_t row = rowOf(box.low.y()); row <= last_row; ++row)
      for (std::size_t column = columnOf(box.low.x()); column <= last_column; ++column)
        forEdgesIn(column, row, [&](std::size_t edge) {
          visit(edge);
          return true;
        });
  }

  Point2 centreOf(std::size_t column, std::size_t row) const {
    return low_ + cell_mm_ * Point2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
  }

  /// The cell of a point if no edge passes through it; nothing otherwise. Between two points of such a cell
  /// there is no edge.
  std::optional<std::size_t> clearCell(const Point2& point) const;
  /// Whether no edge passes through a cell and its eight neighbours.
  bool isClearAround(std::size_t cell) const;
  /// Whether two cells are the same or touch.
  bool areNeighbours(std::size_t cell, std::size_t next) const;

  /// Calls `visit(column, row)` for every cell that a line crosses, until it returns false.
  /// @return whether all were visited
  template <class Visit>
  bool forCellsAlong(const Point2& from, const Point2& to, const Visit& visit) const {
    const Point2& low = from.y() <= to.y() ? from : to;
    const Point2& high = from.y() <= to.y() ? to : from;
    const double slope = high.y() > low.y() ? (high.x() - low.x()) / (high.y() - low.y()) : 0.0;
    const auto [least_x, most_x] = std::minmax(from.x(), to.x());
    for (std::size_t row = rowOf(low.y() - kPad); row <= rowOf(high.y() + kPad); ++row) {
      double begin = least_x;
      double end = most_x;
      if (slope != 0.0) {
        const double y = low_.y() + static_cast<double>(row) * cell_mm_;
        const double one = low.x() + slope * (y - kPad - low.y());
        const double other = low.x() + slope * (y + cell_mm_ + kPad - low.y());
        begin = std::clamp(std::min(one, other), least_x, most_x);
        end = std::clamp(std::max(one, other), least_x, most_x);
      }
      for (std::size_t column = columnOf(begin - kPad); column <= columnOf(end + kPad); ++column)
        if (!visit(column, row)) return false;
    }
    return true;
  }

 private:
  static constexpr double kPad = 1e-7;  // mm: rounding

  std::size_t index(double position, double low, std::size_t count) const {
    return static_cast<std::size_t>(
        std::clamp(std::floor((position - low) / cell_mm_), 0.0, static_cast<double>(count - 1)));
  }

  void sort(const std::vector<std::pair<Point2, Point2>>& edges);

  Point2 low_ = Point2::Zero();
  double cell_mm_ = 1.0;
  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::uint32_t> first_;  ///< index of the first edge of each cell, and the end of the last one
  std::vector<std::uint32_t> edges_;
};

}  // namespace lamina
