// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/voxel/height_map.hpp"

namespace lamina {

/// Measured points fused into one height per cell. In a pass (one sweep of the sensor, in which the surface
/// does not change) a cell holds the mean of its points. The first point of a later pass replaces the earlier
/// height, as the surface has grown since. Memory, and the time for a point, do not grow with the number of
/// points.
class MeasuredSurface {
 public:
  explicit MeasuredSurface(const HeightGrid& grid);

  const HeightGrid& grid() const { return grid_; }

  /// Number of the pass that points are now added to; starts at 1.
  std::uint32_t pass() const { return pass_; }
  /// Ends the pass and begins the next.
  void beginPass() { ++pass_; }

  /// Whether a point was the first of its cell in this pass, a further one, or beyond the grid.
  enum class Fused { First, Further, Outside };

  /// Adds a point. A point that is beyond the grid or not finite changes nothing and is Outside.
  /// @param point  [mm, frame of the grid]
  Fused insert(const Point3& point) {
    const std::size_t index = grid_.cellAt(point.head<2>());
    if (index == HeightGrid::kNoCell || !std::isfinite(point.z())) return Fused::Outside;
    Cell& cell = cells_[index];
    if (cell.pass != pass_) cell = {0.0, pass_, 0};
    cell.sum += point.z();
    return ++cell.points == 1 ? Fused::First : Fused::Further;
  }

  /// Height of a cell [mm]; unknown if it was never seen.
  double height(std::size_t cell) const {
    return cells_[cell].points == 0 ? HeightMap::kUnknown : cells_[cell].sum / cells_[cell].points;
  }
  /// Height of a cell if it was seen in the present pass, otherwise unknown.
  double heightInPass(std::size_t cell) const {
    return cells_[cell].pass == pass_ ? height(cell) : HeightMap::kUnknown;
  }

  /// All heights as they stand.
  HeightMap heights() const;

 private:
  struct Cell {
    double sum = 0.0;
    std::uint32_t pass = 0;
    std::uint32_t points = 0;
  };
  HeightGrid grid_;
  std::vector<Cell> cells_;
  std::uint32_t pass_ = 1;
};

}  // namespace lamina
