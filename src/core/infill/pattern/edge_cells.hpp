// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The edge of an outline that starts at the point of that index.
struct OutlineEdge {
  std::uint32_t outline = 0;
  std::uint32_t edge = 0;
};

/// The edges of outlines by the cells of a grid they pass through: about as many cells as edges, but enough
/// for most to have none.
class EdgeCells {
 public:
  explicit EdgeCells(const std::vector<Polygon>& outlines);

  /// Calls `visit(edge)` for all edges in the cells that the segment passes through; for an edge in several
  /// of them as often.
  template <class Visit>
  void visitNear(const Point2& from, const Point2& to, const Visit& visit) const {
    forCells(from, to, [&](std::size_t cell) {
      for (std::uint32_t i = begin_[cell]; i < begin_[cell + 1]; ++i) visit(edges_[i]);
    });
  }

  /// The cell of a point if no edge passes through it: between two points of one such cell there is none.
  std::optional<std::size_t> clearCell(const Point2& point) const {
    const Point2 at = (point - origin_) / cell_mm_;
    if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < columns_ && at.y() < rows_)) return std::nullopt;
    const std::size_t cell = static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(columns_) +
                             static_cast<std::size_t>(at.x());
    if (begin_[cell] < begin_[cell + 1]) return std::nullopt;
    return cell;
  }

  /// Whether no edge passes through a straight line between points of two clear cells, as there is none in
  /// any cell round the first; false also where that is in doubt.
  bool isClearBetween(std::size_t cell, std::size_t next) const {
    if (!is_clear_around_[cell]) return false;
    const auto columns = static_cast<std::size_t>(columns_);
    const std::size_t row = cell / columns, next_row = next / columns;
    const std::size_t column = cell % columns, next_column = next % columns;
    return next_row + 1 >= row && row + 1 >= next_row && next_column + 1 >= column &&
           column + 1 >= next_column;
  }

 private:
  std::vector<bool> clearAround() const;

  /// Row by row.
  template <class Visit>
  void forCells(const Point2& from, const Point2& to, const Visit& visit) const {
    const Point2 a = (from - origin_) / cell_mm_;
    const Point2 along = (to - from) / cell_mm_;
    const int first_row = clampedFloor(std::min(a.y(), a.y() + along.y()) - kSlack, rows_);
    const int last_row = clampedFloor(std::max(a.y(), a.y() + along.y()) + kSlack, rows_);
    for (int row = std::max(first_row, 0); row <= std::min(last_row, rows_ - 1); ++row) {
      double start = 0.0, end = 1.0;  // the part of the segment in this row
      if (std::abs(along.y()) > kSlack) {
        const double one = (row - kSlack - a.y()) / along.y();
        const double other = (row + 1 + kSlack - a.y()) / along.y();
        start = std::clamp(std::min(one, other), 0.0, 1.0);
        end = std::clamp(std::max(one, other), 0.0, 1.0);
      }
      const double x = a.x() + start * along.x();
      const double y = a.x() + end * along.x();
      const int first = std::max(clampedFloor(std::min(x, y) - kSlack, columns_), 0);
      const int last = std::min(clampedFloor(std::max(x, y) + kSlack, columns_), columns_ - 1);
      for (int column = first; column <= last; ++column)
        visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
              static_cast<std::size_t>(column));
    }
  }

  static int clampedFloor(double position, int count) {
    return static_cast<int>(std::clamp(std::floor(position), -1.0, static_cast<double>(count)));
  }

  static constexpr double kSlack = 1e-6;  ///< cells, far above rounding
  Point2 origin_ = Point2::Zero();
  double cell_mm_ = 1.0;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::uint32_t> begin_;  ///< where each cell's edges begin, and an end
  std::vector<OutlineEdge> edges_;
  std::vector<bool> is_clear_around_;  ///< of each cell: whether it and its neighbours have no edge
};

}  // namespace lamina
