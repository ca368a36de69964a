// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/voxel/voxel_grid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>
#include <tuple>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using Voxel = std::tuple<int, int, int>;

VoxelFrame frameOf(int x, int y, int z) { return {Point3(1, 2, 3), 0.5, {x, y, z}}; }

Voxel voxelIn(const VoxelFrame& frame) {
  const auto& count = frame.count;
  return {*rc::gen::inRange(0, count[0]), *rc::gen::inRange(0, count[1]), *rc::gen::inRange(0, count[2])};
}

TEST(VoxelFrameTest, CoversABoxOnWholeMultiplesOfTheVoxel) {
  const VoxelFrame frame = voxelFrame({Point3(-0.12, 0.1, 0.3), Point3(0.1, 0.49, 0.7)}, 0.1);
  EXPECT_TRUE(frame.corner.isApprox(Point3(-0.2, 0.1, 0.3)));
  EXPECT_EQ(frame.count, (std::array<int, 3>{3, 4, 4}));
  EXPECT_TRUE(frame.centre(2, 0, 1).isApprox(Point3(0.05, 0.15, 0.45)));
}

TEST(VoxelFrameTest, CountsThePublishedSizes) {
  const auto voxels = [](double x, double y, double z, double voxel) {
    return voxelFrame({Point3::Zero(), Point3(x, y, z)}, voxel).voxelCount();
  };
  EXPECT_EQ(voxels(80, 10, 4, 0.1), 3'200'000);
  EXPECT_EQ(voxels(80, 10, 4, 0.005), 25'600'000'000);
  EXPECT_EQ(voxels(200, 250, 500, 0.1), 25'000'000'000);
  EXPECT_EQ(voxels(181, 181, 181, 0.1), 5'929'741'000);
}

TEST(VoxelFrameTest, RefusesWhatItCannotCountAndNamesWhatFits) {
  const Box3 box{Point3::Zero(), Point3(1000, 1, 1)};
  EXPECT_THROW(voxelFrame(box, 0.0), InvalidInput);
  EXPECT_THROW(voxelFrame({}, 0.1), InvalidInput);
  try {
    voxelFrame(box, 1e-9);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("must be at least"), std::string::npos);
  }
}

TEST(VoxelGridTest, HoldsWhatWasFilled) {
  EXPECT_TRUE(rc::check([] {
    const VoxelFrame frame =
        frameOf(*rc::gen::inRange(1, 150), *rc::gen::inRange(1, 20), *rc::gen::inRange(1, 20));
    VoxelGrid grid(frame);
    std::set<Voxel> filled;
    const int changes = *rc::gen::inRange(0, 60);
    for (int change = 0; change < changes; ++change) {
      const auto [i, j, k] = voxelIn(frame);
      if (*rc::gen::inRange(0, 4) == 0) {
        grid.open(i, j, k);
        filled.erase({i, j, k});
      } else {
        grid.fill(i, j, k);
        filled.insert({i, j, k});
      }
    }
    RC_ASSERT(grid.solidCount() == static_cast<std::int64_t>(filled.size()));
    for (int k = -1; k <= frame.count[2]; ++k)
      for (int j = -1; j <= frame.count[1]; ++j)
        for (int i = -1; i <= frame.count[0]; ++i)
          RC_ASSERT(grid.isSolid(i, j, k) == (filled.count({i, j, k}) != 0));
  }));
}

TEST(VoxelGridTest, ACropIsTheSameVoxelsAtTheSamePlace) {
  EXPECT_TRUE(rc::check([] {
    const VoxelFrame frame =
        frameOf(*rc::gen::inRange(1, 150), *rc::gen::inRange(1, 12), *rc::gen::inRange(1, 12));
    VoxelGrid grid(frame);
    for (int n = 0; n < 200; ++n) {
      const auto [i, j, k] = voxelIn(frame);
      grid.fill(i, j, k);
    }
    VoxelRange range;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      range.low[axis] = *rc::gen::inRange(-70, frame.count[axis]);
      range.high[axis] = range.low[axis] + *rc::gen::inRange(1, frame.count[axis] + 70);
    }
    const VoxelGrid crop = cropped(grid, range);
    RC_ASSERT((crop.frame().centre(0, 0, 0) - frame.centre(range.low[0], range.low[1], range.low[2])).norm() <
              1e-9);
    std::int64_t solid = 0;
    for (int k = range.low[2]; k < range.high[2]; ++k)
      for (int j = range.low[1]; j < range.high[1]; ++j)
        for (int i = range.low[0]; i < range.high[0]; ++i) {
          solid += grid.isSolid(i, j, k) ? 1 : 0;
          RC_ASSERT(crop.isSolid(i - range.low[0], j - range.low[1], k - range.low[2]) ==
                    grid.isSolid(i, j, k));
        }
    RC_ASSERT(crop.solidCount() == solid);
  }));
}

TEST(VoxelGridTest, ReportsTheRangeOfWhatIsSolid) {
  VoxelGrid grid(frameOf(200, 30, 30));
  EXPECT_TRUE(grid.solidRange().isEmpty());
  grid.fill(65, 3, 29);
  grid.fill(130, 20, 7);
  const VoxelRange range = grid.solidRange();
  EXPECT_EQ(range.low, (std::array<int, 3>{65, 3, 7}));
  EXPECT_EQ(range.high, (std::array<int, 3>{131, 21, 30}));
}

TEST(VoxelGridTest, HoldsOneBitAVoxelWhereItIsSolid) {
  VoxelGrid grid(frameOf(640, 640, 640));
  const std::size_t empty = grid.bytes();
  EXPECT_LE(empty, 640U * 640U * 640U / 4096U * 4U);
  for (int k = 0; k < 64; ++k)
    for (int j = 0; j < 64; ++j)
      for (int w = 0; w < 10; ++w) grid.fillWord(w, j, k, ~std::uint64_t{0});
  EXPECT_LE(static_cast<double>(grid.bytes() - empty), 640.0 * 64 * 64 / 8 * 1.02);
}

TEST(VoxelsIn, TakesTheVoxelsWhoseCentresLieInside) {
  const VoxelFrame frame = frameOf(10, 10, 10);
  const VoxelRange range = voxelsIn(frame, {Point3(1.3, 2.0, 0.0), Point3(2.7, 2.75, 100)});
  EXPECT_EQ(range.low, (std::array<int, 3>{1, 0, 0}));
  EXPECT_EQ(range.high, (std::array<int, 3>{3, 2, 10}));
  EXPECT_TRUE(voxelsIn(frame, {Point3(100, 100, 100), Point3(101, 101, 101)}).isEmpty());
}

}  // namespace
}  // namespace lamina
