// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/voxel/voxel_view.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace lamina {
namespace {

/// A block of voxels in a frame one voxel wider on all sides.
VoxelGrid blockOf(int x, int y, int z) {
  VoxelGrid grid({Point3(1, 2, 3), 0.5, {x + 2, y + 2, z + 2}});
  for (int k = 1; k <= z; ++k)
    for (int j = 1; j <= y; ++j)
      for (int i = 1; i <= x; ++i) grid.fill(i, j, k);
  return grid;
}

TEST(VoxelView, SurfaceOfABlockIsTheBlockLessItsInside) {
  EXPECT_EQ(surfaceVoxels(blockOf(130, 5, 4)).size(), 130U * 5 * 4 - 128U * 3 * 2);
  EXPECT_EQ(surfaceVoxels(blockOf(1, 1, 1)).front(), Point3(1.75, 2.75, 3.75));
  EXPECT_TRUE(surfaceVoxels(VoxelGrid({Point3::Zero(), 1.0, {3, 3, 3}})).empty());
}

TEST(VoxelView, SurfaceVoxelsAreThoseWithAnOpenNeighbour) {
  EXPECT_TRUE(rc::check([] {
    VoxelGrid grid({Point3::Zero(), 1.0, {70, 4, 4}});
    const int holes = *rc::gen::inRange(0, 60);
    for (int i = 0; i < 70; ++i)
      for (int jk = 0; jk < 16; ++jk) grid.fill(i, jk % 4, jk / 4);
    for (int h = 0; h < holes; ++h)
      grid.open(*rc::gen::inRange(0, 70), *rc::gen::inRange(0, 4), *rc::gen::inRange(0, 4));
    std::vector<Point3> expected;
    for (int k = 0; k < 4; ++k)
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 70; ++i) {
          const bool is_enclosed = grid.isSolid(i - 1, j, k) && grid.isSolid(i + 1, j, k) &&
                                   grid.isSolid(i, j - 1, k) && grid.isSolid(i, j + 1, k) &&
                                   grid.isSolid(i, j, k - 1) && grid.isSolid(i, j, k + 1);
          if (grid.isSolid(i, j, k) && !is_enclosed) expected.push_back(grid.frame().centre(i, j, k));
        }
    RC_ASSERT(surfaceVoxels(grid) == expected);
  }));
}

TEST(VoxelView, CoarserCubesAreSolidWhereHalfOfTheirVoxelsAre) {
  VoxelGrid grid({Point3(1, 1, 1), 0.5, {5, 2, 2}});
  for (int n = 0; n < 4; ++n) grid.fill(n % 2, n / 2, 0);  // 4 of the first 8
  for (int n = 0; n < 3; ++n) grid.fill(2 + n % 2, n / 2, 0);
  grid.fill(4, 0, 0);  // 1 of a cube that is half beyond the frame
  const VoxelGrid coarse = coarsened(grid, 2);
  EXPECT_EQ(coarse.frame(), (VoxelFrame{Point3(1, 1, 1), 1.0, {3, 1, 1}}));
  EXPECT_TRUE(coarse.isSolid(0, 0, 0));
  EXPECT_FALSE(coarse.isSolid(1, 0, 0));
  EXPECT_FALSE(coarse.isSolid(2, 0, 0));
}

TEST(VoxelView, WhatIsShownStaysWithinItsLimit) {
  const VoxelGrid block = blockOf(40, 40, 40);
  const std::size_t all = surfaceVoxels(block).size();
  EXPECT_EQ(shownVoxels(block, all).size(), all);
  const auto fewer = shownVoxels(block, 1000);
  EXPECT_LE(fewer.size(), 1000U);
  EXPECT_GT(fewer.size(), 200U);
  const Mesh mesh = shownSurface(block, 2000);
  EXPECT_LE(mesh.triangles.size(), 2000U);
  EXPECT_NEAR(std::cbrt(volume(mesh)), 20.0, 2.0) << "about the same block";
}

}  // namespace
}  // namespace lamina
