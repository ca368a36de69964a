// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/voxel/height_map.hpp"

#include <algorithm>

namespace lamina {

double HeightMap::nearest(const Point2& point) const {
  const std::size_t cell = grid_.cellAt(point);
  return cell == HeightGrid::kNoCell ? kUnknown : heights_[cell];
}

double HeightMap::bilinear(const Point2& point) const {
  const Point2 at = (point - grid_.origin) / grid_.cell_mm - Point2(0.5, 0.5);
  if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < grid_.columns - 1 && at.y() < grid_.rows - 1))
    return nearest(point);
  const int column = static_cast<int>(at.x());
  const int row = static_cast<int>(at.y());
  const double u = at.x() - column;
  const double v = at.y() - row;
  const double* low = &heights_[grid_.cell(column, row)];
  const double* high = low + grid_.columns;
  const double height = (1 - v) * ((1 - u) * low[0] + u * low[1]) + v * ((1 - u) * high[0] + u * high[1]);
  return std::isnan(height) ? nearest(point) : height;
}

HeightRange heightRange(const HeightMap& map) {
  HeightRange range;
  for (const double height : map.heights()) {
    if (std::isnan(height)) continue;
    range.low = range.known == 0 ? height : std::min(range.low, height);
    range.high = range.known == 0 ? height : std::max(range.high, height);
    ++range.known;
  }
  return range;
}

double volumeUnder(const HeightMap& map) {
  double sum = 0.0;
  for (const double height : map.heights())
    if (!std::isnan(height)) sum += height;
  return sum * map.grid().cell_mm * map.grid().cell_mm;
}

}  // namespace lamina
