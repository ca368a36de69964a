// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Points sorted into square cells, so that those near a position are found in a time that does not grow with
/// the number of points.
class PointGrid {
 public:
  /// @param box      where most points will lie; points outside it are found too, only more slowly
  /// @param cell_mm  positive; best about the distances that are searched. Larger cells are used if there
  ///   would be more than four million
  PointGrid(const Box2& box, double cell_mm);

  /// Adds a point.
  /// @return index of the point, from 0 in the order of insertion
  std::uint32_t insert(const Point2& point);
  /// Removes a point from searches; its index is not used again.
  void remove(std::uint32_t index);

  /// All points ever inserted, by index.
  const std::vector<Point2>& points() const { return points_; }

  /// Calls visit(index, squared distance) for each point at most `radius` away, in an order that depends on
  /// the points and the order of insertion alone.
  template <class Visit>
  void visitNear(const Point2& place, double radius, Visit visit) const;

  /// Calls visit(index) for each point in the box or on its border, in the same order.
  template <class Visit>
  void visitIn(const Box2& box, Visit visit) const;

  /// Whether test(index, squared distance) holds for a point no farther than `radius`.
  template <class Test>
  bool hasNear(const Point2& place, double radius, Test test) const;

  /// Whether a point is nearer than `distance`.
  bool hasNearer(const Point2& place, double distance) const;

  /// Index of the nearest point; of points equally near the lowest. Nothing if the grid is empty.
  std::optional<std::uint32_t> nearest(const Point2& place) const;

  /// Index of the nearest point; of points equally near within `tie_mm`, the one with the smaller x, then y.
  /// Nothing if the grid is empty.
  std::optional<std::uint32_t> nearest(const Point2& place, double tie_mm) const;

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// A point that a search has found so far.
  struct Candidate {
    double squared = std::numeric_limits<double>::infinity();
    std::uint32_t index = kNone;
  };

  /// Calls visit(index) for the points of the cells from corner to corner until it returns true.
  /// @return whether it did
  template <class Visit>
  bool visitCells(const Point2& low, const Point2& high, const Visit& visit) const;
  void searchCell(int column, int row, const Point2& place, Candidate& best) const;
  void searchLoop(int radius, const Point2& place, Candidate& best) const;
  std::size_t cellAt(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  int column(double x) const { return cellOf(x - low_.x(), columns_); }
  int row(double y) const { return cellOf(y - low_.y(), rows_); }
  int cellOf(double offset, int count) const;
  std::size_t cell(const Point2& point) const;

  Point2 low_ = Point2::Zero();
  double cell_mm_;
  int columns_ = 1;
  int rows_ = 1;
  std::size_t count_ = 0;             ///< number of points that are not removed
  std::vector<std::uint32_t> first_;  ///< point of each cell
  std::vector<std::uint32_t> next_;   ///< point of the same cell, for each point
  std::vector<Point2> points_;
};

template <class Visit>
bool PointGrid::visitCells(const Point2& low, const Point2& high, const Visit& visit) const {
  const int last_column = column(high.x());
  const int last_row = row(high.y());
  for (int r = row(low.y()); r <= last_row; ++r)
    for (int c = column(low.x()); c <= last_column; ++c)
      for (std::uint32_t i = first_[cellAt(c, r)]; i != kNone; i = next_[i])
        if (visit(i)) return true;
  return false;
}

template <class Visit>
void PointGrid::visitNear(const Point2& place, double radius, Visit visit) const {
  hasNear(place, radius, [&](std::uint32_t index, double squared) {
    visit(index, squared);
    return false;
  });
}

template <class Test>
bool PointGrid::hasNear(const Point2& place, double radius, Test test) const {
  const Point2 reach(radius, radius);
  return visitCells(place - reach, place + reach, [&](std::uint32_t index) {
    const double squared = (points_[index] - place).squaredNorm();
    return squared <= radius * radius && test(index, squared);
  });
}

template <class Visit>
void PointGrid::visitIn(const Box2& box, Visit visit) const {
  visitCells(box.low, box.high, [&](std::uint32_t index) {
    const Point2& point = points_[index];
    if ((point.array() >= box.low.array()).all() && (point.array() <= box.high.array()).all()) visit(index);
    return false;
  });
}

}  // namespace lamina
