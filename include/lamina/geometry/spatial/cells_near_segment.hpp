// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "lamina/geometry/voxel/height_grid.hpp"

namespace lamina {

/// Calls `visit(cell, distance, along)` for every cell whose centre is at most `reach` from a segment [mm],
/// row by row. `distance` is that of the centre [mm]; `along` is the position of the nearest point on the
/// segment, 0 at the start and 1 at the end. Time is linear in the length of the segment, whatever its
/// direction.
template <class Visit>
void forCellsNearSegment(const HeightGrid& grid, const Point2& start, const Point2& end, double reach,
                         const Visit& visit) {
  const Point2 along = end - start;
  const double squared = along.squaredNorm();
  const auto index = [&grid](double position, double origin, int count) {
    return static_cast<int>(std::clamp(std::floor((position - origin) / grid.cell_mm), -1.0, double(count)));
  };
  const int first_row = std::max(0, index(std::min(start.y(), end.y()) - reach, grid.origin.y(), grid.rows));
  const int last_row =
      std::min(grid.rows - 1, index(std::max(start.y(), end.y()) + reach, grid.origin.y(), grid.rows));
  for (int row = first_row; row <= last_row; ++row) {
    const double y = grid.centre(0, row).y();
    double from = 0.0, to = 1.0;  // the part of the segment within reach of the row's middle line
    if (std::abs(along.y()) > 1e-12) {
      const double one = (y - reach - start.y()) / along.y();
      const double other = (y + reach - start.y()) / along.y();
      from = std::clamp(std::min(one, other), 0.0, 1.0);
      to = std::clamp(std::max(one, other), 0.0, 1.0);
    }
    const double x_from = start.x() + from * along.x();
    const double x_to = start.x() + to * along.x();
    const int first = std::max(0, index(std::min(x_from, x_to) - reach, grid.origin.x(), grid.columns));
    const int last =
        std::min(grid.columns - 1, index(std::max(x_from, x_to) + reach, grid.origin.x(), grid.columns));
    for (int column = first; column <= last; ++column) {
      const Point2 from_start = grid.centre(column, row) - start;
      const double at = squared > 0.0 ? std::clamp(from_start.dot(along) / squared, 0.0, 1.0) : 1.0;
      const double distance = (from_start - at * along).norm();
      if (distance <= reach) visit(grid.cell(column, row), distance, at);
    }
  }
}

}  // namespace lamina
