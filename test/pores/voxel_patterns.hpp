// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rapidcheck.h>

#include <array>

#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina {

/// A solid block with voxels of 1 mm.
inline VoxelGrid solidBlock(int x, int y, int z) {
  VoxelGrid grid({Point3::Zero(), 1.0, {x, y, z}});
  for (int k = 0; k < z; ++k)
    for (int j = 0; j < y; ++j)
      for (int i = 0; i < x; ++i) grid.fill(i, j, k);
  return grid;
}

inline void openBox(VoxelGrid& grid, const VoxelRange& range) {
  for (int k = range.low[2]; k < range.high[2]; ++k)
    for (int j = range.low[1]; j < range.high[1]; ++j)
      for (int i = range.low[0]; i < range.high[0]; ++i) grid.open(i, j, k);
}

/// Any grid of up to 140 x 9 x 9 voxels of 0.5 mm, mostly solid or mostly open.
inline VoxelGrid arbitraryGrid() {
  const std::array<int, 3> count{*rc::gen::inRange(1, 140), *rc::gen::inRange(1, 10),
                                 *rc::gen::inRange(1, 10)};
  VoxelGrid grid({Point3(1, 2, 3), 0.5, count});
  const auto seed = *rc::gen::inRange<std::uint64_t>(1, 1U << 30U);
  const int share = *rc::gen::inRange(1, 16);
  std::uint64_t state = seed;
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j)
      for (int i = 0; i < count[0]; ++i) {
        state = state * 6364136223846793005U + 1442695040888963407U;
        if (static_cast<int>(state >> 60U) < share) grid.fill(i, j, k);
      }
  return grid;
}

}  // namespace lamina
