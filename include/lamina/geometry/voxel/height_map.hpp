// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "lamina/geometry/voxel/height_grid.hpp"

namespace lamina {

/// One height [mm, bed frame], or difference of heights, for each cell of a grid; NaN where nothing is known.
/// A value type, whose grid is set on construction.
class HeightMap {
 public:
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  HeightMap() = default;
  explicit HeightMap(const HeightGrid& grid, double height = kUnknown)
      : grid_(grid), heights_(grid.cellCount(), height) {}

  const HeightGrid& grid() const { return grid_; }
  /// Heights of all cells, row by row.
  const std::vector<double>& heights() const { return heights_; }

  double at(std::size_t cell) const { return heights_[cell]; }
  bool isKnown(std::size_t cell) const { return !std::isnan(heights_[cell]); }
  void set(std::size_t cell, double height) { heights_[cell] = height; }

  /// Height of the cell in which the point lies; NaN outside the grid.
  double nearest(const Point2& point) const;

  /// Height at a point, interpolated linearly in x and y between the centres of the four cells around it. If
  /// one of the four is unknown or outside the grid, the result is that of `nearest`.
  double bilinear(const Point2& point) const;

 private:
  HeightGrid grid_;
  std::vector<double> heights_;
};

/// Smallest and largest known height.
struct HeightRange {
  double low = HeightMap::kUnknown;  ///< NaN if no cell is known
  double high = HeightMap::kUnknown;
  std::size_t known = 0;  ///< number of cells with a known height
};
HeightRange heightRange(const HeightMap& map);

/// Volume below the map: the sum of the known cells' heights times the area of a cell [mm³].
double volumeUnder(const HeightMap& map);

}  // namespace lamina
