// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/measured_surface.hpp"

namespace lamina {

MeasuredSurface::MeasuredSurface(const HeightGrid& grid) : grid_(grid), cells_(grid.cellCount()) {}

HeightMap MeasuredSurface::heights() const {
  HeightMap map(grid_);
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) map.set(cell, height(cell));
  return map;
}

}  // namespace lamina
