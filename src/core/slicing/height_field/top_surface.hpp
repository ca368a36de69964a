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

/// Each cell is cut in two triangles along its rising diagonal: 2 c is the lower right half of cell c, with
/// its low, right and high corner, 2 c + 1 the upper left one, with its low, left and high corner: each runs
/// along one axis and then along the other.
inline std::array<std::size_t, 3> cornersOfHalf(const HeightGrid& cells, std::size_t half) {
  const std::size_t cell = half / 2;
  const auto columns = static_cast<std::size_t>(cells.columns);
  const std::size_t width = columns + 1;
  const std::size_t low = cell + cell / columns;  // a row has one corner more than cells
  if (half % 2 == 0) return {low, low + 1, low + width + 1};
  return {low, low + width, low + width + 1};
}

/// Length of the slope of what is linear in a half, by its values at the corners [1/mm].
inline double slopeOfHalf(const std::array<double, 3>& values, double cell_mm) {
  return std::hypot(values[1] - values[0], values[2] - values[1]) / cell_mm;
}

/// What is seen of a part from above, on a grid. Heights are above the bed [mm].
struct TopSurface {
  /// At each corner of the cells, row by row: that of the highest surface; none where there is none.
  std::vector<std::optional<double>> at_corner;
  /// The same with two more rings of corners around it, each in line with two further in; all positive.
  std::vector<std::optional<double>> prolonged;
  /// Of each half with material, at its corners: what is linear between them is nowhere lower than the part.
  std::vector<std::optional<std::array<double, 3>>> over_half;
};

/// @param mesh     closed, with edges no longer than a cell, inside the grid
/// @param base_mm  z of the bed
TopSurface topSurface(const Mesh& mesh, const HeightGrid& cells, double base_mm);

}  // namespace lamina
