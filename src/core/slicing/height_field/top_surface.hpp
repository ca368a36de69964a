// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/voxel/height_grid.hpp"

namespace lamina {

/// Number of the corner at the low side of a cell, also of cells one beyond the grid: corners are numbered
/// row by row, and a row has one more of them than cells.
inline std::size_t cornerOf(const HeightGrid& cells, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells.columns + 1) +
         static_cast<std::size_t>(column);
}

/// The three corners of a triangular half of a cell. Each cell is cut into two triangles along its rising
/// diagonal: half 2 c is the lower right one of cell c, with its low, right and high corner; half 2 c + 1 is
/// the upper left one, with its low, left and high corner. The line through the three corners runs along one
/// axis, then along the other.
inline std::array<std::size_t, 3> cornersOfHalf(const HeightGrid& cells, std::size_t half) {
  const std::size_t cell = half / 2;
  const auto columns = static_cast<std::size_t>(cells.columns);
  const std::size_t width = columns + 1;
  const std::size_t low = cell + cell / columns;  // a row has one corner more than cells
  if (half % 2 == 0) return {low, low + 1, low + width + 1};
  return {low, low + width, low + width + 1};
}

/// Length of the gradient in a half, of the linear function with these values at the corners [1/mm].
inline double slopeOfHalf(const std::array<double, 3>& values, double cell_mm) {
  return std::hypot(values[1] - values[0], values[2] - values[1]) / cell_mm;
}

/// Surface of a part as seen from above, on a grid. Heights are above the bed [mm].
struct TopSurface {
  /// For each corner of the cells, row by row, the height of the highest surface; nothing beside the part.
  std::vector<std::optional<double>> at_corner;
  /// `at_corner` with two more rings of corners around it, extrapolated linearly from two corners further in;
  /// all heights are positive.
  std::vector<std::optional<double>> prolonged;
  /// For each half with material, heights at its corners such that the plane through them is nowhere lower
  /// than the part.
  std::vector<std::optional<std::array<double, 3>>> over_half;
};

/// Samples the upper side of a part.
/// @param mesh     closed, with edges no longer than a cell, inside the grid
/// @param base_mm  z of the bed
TopSurface topSurface(const Mesh& mesh, const HeightGrid& cells, double base_mm);

}  // namespace lamina
