// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "lamina/base/random.hpp"
#include "lamina/geometry/voxel/voxel_grid.hpp"

namespace lamina::test {

/// All voxels solid; the corner is off the origin.
inline VoxelGrid solidBox(const std::array<int, 3>& count, double voxel_mm) {
  VoxelGrid grid({Point3(1.0, 2.0, 3.0), voxel_mm, count});
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j)
      for (int i = 0; i < count[0]; ++i) grid.fill(i, j, k);
  return grid;
}

/// A cube on one side of a gyroid of four periods along each side.
inline VoxelGrid gyroid(int side, double voxel_mm) {
  VoxelGrid grid({Point3::Zero(), voxel_mm, {side, side, side}});
  const auto angle = [&](int i) { return 8.0 * M_PI * (i + 0.5) / side; };
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const double x = angle(i), y = angle(j), z = angle(k);
        if (std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x) < 0.0)
          grid.fill(i, j, k);
      }
  return grid;
}

/// Each voxel solid with a probability.
inline VoxelGrid noise(const std::array<int, 3>& count, double probability, std::uint64_t seed) {
  VoxelGrid grid({Point3::Zero(), 1.0, count});
  Random random(seed);
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j)
      for (int i = 0; i < count[0]; ++i)
        if (random.uniform(0.0, 1.0) < probability) grid.fill(i, j, k);
  return grid;
}

}  // namespace lamina::test
