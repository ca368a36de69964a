// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/pores/voxel_surface.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "pores/voxel_patterns.hpp"

namespace lamina {
namespace {

TEST(VoxelSurfaceTest, OfABlockIsThatOfABox) {
  EXPECT_DOUBLE_EQ(voxelFaceArea(solidBlock(64, 3, 5)), 2.0 * (64 * 3 + 64 * 5 + 3 * 5));
  EXPECT_DOUBLE_EQ(voxelFaceArea(solidBlock(65, 3, 5)), 2.0 * (65 * 3 + 65 * 5 + 3 * 5));
}

TEST(VoxelSurfaceTest, CountsEveryFaceBetweenSolidAndOpen) {
  EXPECT_TRUE(rc::check([] {
    const VoxelGrid grid = arbitraryGrid();
    const auto& count = grid.frame().count;
    int faces = 0;
    for (int k = 0; k <= count[2]; ++k)
      for (int j = 0; j <= count[1]; ++j)
        for (int i = 0; i <= count[0]; ++i) {
          const bool here = grid.isSolid(i, j, k);
          faces += int{here != grid.isSolid(i - 1, j, k)} + int{here != grid.isSolid(i, j - 1, k)} +
                   int{here != grid.isSolid(i, j, k - 1)};
        }
    RC_ASSERT(std::abs(voxelFaceArea(grid) - 0.25 * faces) < 1e-9 * (1 + faces));
  }));
}

}  // namespace
}  // namespace lamina
