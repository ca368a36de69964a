// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The edges of regions by rows along x, so that a place is tested against few of them.
class EdgeRows {
 public:
  EdgeRows(const Regions& regions, double row_mm);

  bool contains(const Point2& place) const;
  /// Where outlines cross the line at that y, from left to right: inside begins and ends in turn.
  std::vector<double> crossings(double y) const;
  /// Where the line crosses outlines, in order: parts of its length, from 0 to 1.
  std::vector<double> cuts(const Point2& from, const Point2& to) const;
  const Box2& box() const { return box_; }

 private:
  using Edge = std::pair<Point2, Point2>;

  std::size_t rowOf(double y) const;

  Box2 box_;
  double row_mm_;
  std::vector<std::vector<Edge>> rows_;
};

}  // namespace lamina
