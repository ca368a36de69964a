// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/voxel/strand_thickness.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

VoxelGrid openGrid(int x, int y, int z) { return VoxelGrid(VoxelFrame{Point3::Zero(), 0.1, {x, y, z}}); }

VoxelGrid boxed(VoxelGrid grid, const VoxelRange& range) {
  for (int k = range.low[2]; k < range.high[2]; ++k)
    for (int j = range.low[1]; j < range.high[1]; ++j)
      for (int i = range.low[0]; i < range.high[0]; ++i) grid.fill(i, j, k);
  return grid;
}

TEST(StrandThickness, OfASlabIsItsHeight) {
  for (const int height : {1, 2, 3, 4, 7}) {
    // Across the border between two words.
    const VoxelGrid slab = boxed(openGrid(130, 40, 20), {{50, 5, 6}, {100, 35, 6 + height}});
    const StrandThickness found = strandThicknessOf(slab);
    EXPECT_EQ(found.voxels, std::min(height, 4));
    EXPECT_DOUBLE_EQ(found.thin_share, height < 4 ? 1.0 : 0.0);
  }
}

TEST(StrandThickness, CountsWhatIsThinBesideWhatIsNot) {
  VoxelGrid grid = boxed(openGrid(40, 30, 30), {{0, 0, 0}, {10, 10, 10}});
  grid = boxed(std::move(grid), {{10, 4, 4}, {35, 5, 5}});
  const StrandThickness found = strandThicknessOf(grid);
  EXPECT_NEAR(found.thin_share, 25.0 / 1025.0, 1e-15);
  EXPECT_EQ(found.voxels, 4);
  EXPECT_EQ(inCubes(grid, 1).solidCount(), 1025);
  EXPECT_EQ(strandThicknessOf(openGrid(5, 5, 5)).voxels, 0);
}

/// Every cube of the grid one by one.
bool isInCube(const VoxelGrid& grid, std::array<int, 3> at, int side) {
  const auto isSolidCube = [&](int x, int y, int z) {
    for (int k = z; k < z + side; ++k)
      for (int j = y; j < y + side; ++j)
        for (int i = x; i < x + side; ++i)
          if (!grid.isSolid(i, j, k)) return false;
    return true;
  };
  for (int z = at[2] - side + 1; z <= at[2]; ++z)
    for (int y = at[1] - side + 1; y <= at[1]; ++y)
      for (int x = at[0] - side + 1; x <= at[0]; ++x)
        if (isSolidCube(x, y, z)) return true;
  return false;
}

TEST(StrandThickness, CubesAreThoseThatALookAtEachFinds) {
  EXPECT_TRUE(rc::check("boxes at random", [](std::uint64_t seed) {
    Random random(seed);
    VoxelGrid grid = openGrid(70, 12, 11);
    const auto below = [&](int most) { return static_cast<int>(random.uniform(0.0, most)); };
    for (int n = 0; n < 8; ++n) {
      const std::array<int, 3> low = {below(64), below(8), below(8)};
      grid =
          boxed(std::move(grid), {low,
                                  {std::min(70, low[0] + 1 + below(9)), std::min(12, low[1] + 1 + below(5)),
                                   std::min(11, low[2] + 1 + below(5))}});
    }
    const int side = 1 + below(5);
    const VoxelGrid cubes = inCubes(grid, side);
    for (int k = 0; k < 11; ++k)
      for (int j = 0; j < 12; ++j)
        for (int i = 0; i < 70; ++i) RC_ASSERT(cubes.isSolid(i, j, k) == isInCube(grid, {i, j, k}, side));
  }));
}

}  // namespace
}  // namespace lamina
