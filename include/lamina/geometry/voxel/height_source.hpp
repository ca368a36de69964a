// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "lamina/geometry/voxel/height_map.hpp"

namespace lamina {

/// Heights of the cells of a grid, queried one at a time, wherever they are stored.
struct HeightSource {
  HeightGrid grid;
  /// Height of a cell of the grid [mm, bed frame]; NaN where nothing is known.
  std::function<double(int column, int row)> height;
};

/// The heights of a map as a source.
/// @param map  must outlive the source
inline HeightSource sourceOf(const HeightMap& map) {
  return {map.grid(), [&map](int column, int row) { return map.at(map.grid().cell(column, row)); }};
}

}  // namespace lamina
