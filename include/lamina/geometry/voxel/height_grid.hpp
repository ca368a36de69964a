// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A grid of square cells over a rectangle of the bed, in which height maps have their values. Column i and
/// row j count along x and y from the corner at `origin`; cells are numbered row by row.
struct HeightGrid {
  static constexpr std::size_t kNoCell = std::numeric_limits<std::size_t>::max();
  static constexpr std::size_t kMostCells = 16'000'000;

  Point2 origin = Point2::Zero();  ///< corner of the first cell [mm, bed frame]
  double cell_mm = 1.0;            ///< side of a cell
  int columns = 0;
  int rows = 0;

  std::size_t cellCount() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  int column(std::size_t cell) const { return static_cast<int>(cell % static_cast<std::size_t>(columns)); }
  int row(std::size_t cell) const { return static_cast<int>(cell / static_cast<std::size_t>(columns)); }

  bool contains(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns && row < rows;
  }

  /// The cell in which a point lies; `kNoCell` for points outside the grid and points that are not finite.
  /// The low edges belong to a cell, its high edges to the next.
  std::size_t cellAt(const Point2& point) const {
    const double x = (point.x() - origin.x()) / cell_mm;
    const double y = (point.y() - origin.y()) / cell_mm;
    if (!(x >= 0.0 && y >= 0.0 && x < columns && y < rows)) return kNoCell;
    return cell(static_cast<int>(x), static_cast<int>(y));
  }

  /// Middle of a cell [mm, bed frame].
  Point2 centre(int column, int row) const { return origin + cell_mm * Point2(column + 0.5, row + 0.5); }
  Point2 centre(std::size_t cell) const { return centre(column(cell), row(cell)); }

  /// The rectangle that the cells cover [mm, bed frame].
  Box2 area() const { return {origin, origin + cell_mm * Point2(columns, rows)}; }

  friend bool operator==(const HeightGrid& a, const HeightGrid& b) {
    return a.origin == b.origin && a.cell_mm == b.cell_mm && a.columns == b.columns && a.rows == b.rows;
  }
};

/// The grid whose cells cover `area`, starting at its low corner.
/// @throws InvalidInput if the area is empty or not finite, the cell size is not positive, or more than
///   `HeightGrid::kMostCells` cells would result; then it names the smallest cell size that fits
HeightGrid heightGrid(const Box2& area, double cell_mm);

}  // namespace lamina
