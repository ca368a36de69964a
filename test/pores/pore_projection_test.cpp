// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/pores/pore_projection.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/pores/layer_pores.hpp"
#include "pores/voxel_patterns.hpp"

namespace lamina {
namespace {

VoxelGrid blockOf50um(int x, int y, int z) {
  VoxelGrid made({Point3::Zero(), 0.05, {x, y, z}});
  const VoxelGrid block = solidBlock(x, y, z);
  for (int k = 0; k < z; ++k)
    for (int j = 0; j < y; ++j)
      for (int w = 0; w < block.wordCount(); ++w) made.fillWord(w, j, k, block.word(w, j, k));
  return made;
}

TEST(PoreProjectionTest, AHoleHasTheDiameterOfTheDiscOfItsArea) {
  VoxelGrid grid = blockOf50um(100, 60, 5);
  openBox(grid, {{50, 20, 0}, {70, 40, 5}});
  const PoreProjection projection = projectPores(grid);
  EXPECT_EQ(projection.innerCount(), 1);
  EXPECT_NEAR(projection.meanDiameterUm(), 1128.4, 0.05);
}

TEST(PoreProjectionTest, HolesAtTheBorderDoNotCountAndWithoutAnyTheMeanIsZero) {
  VoxelGrid grid = blockOf50um(100, 60, 5);
  openBox(grid, {{80, 0, 0}, {100, 20, 5}});
  openBox(grid, {{20, 20, 0}, {40, 40, 4}});  // does not go through
  const PoreProjection projection = projectPores(grid);
  EXPECT_EQ(projection.openings.groups.size(), 1U);
  EXPECT_EQ(projection.innerCount(), 0);
  EXPECT_EQ(projection.meanDiameterUm(), 0.0);
}

TEST(PoreProjectionTest, HolesThatMeetAtACornerAreTwo) {
  VoxelGrid grid = blockOf50um(30, 30, 2);
  openBox(grid, {{5, 5, 0}, {10, 10, 2}});
  openBox(grid, {{10, 10, 0}, {20, 20, 2}});
  const PoreProjection projection = projectPores(grid);
  EXPECT_EQ(projection.innerCount(), 2);
  EXPECT_NEAR(projection.meanDiameterUm(), 50.0 * (5.0 + 10.0) / std::sqrt(M_PI), 1e-9);
}

TEST(LayerPoresTest, CountWhatIsCutOffFromTheBorder) {
  // Two layers of two slices: a ring in the lower one, a full plate in the upper one.
  VoxelGrid grid({Point3(0, 0, 1), 0.5, {12, 12, 4}});
  for (int k = 0; k < 4; ++k)
    for (int j = 1; j < 11; ++j)
      for (int i = 1; i < 11; ++i) grid.fill(i, j, k);
  openBox(grid, {{3, 3, 0}, {9, 9, 2}});
  NoProgress nobody;
  const auto layers = poresByLayer(grid, {{1.0, 2.0}, {2.0, 3.0}, {5.0, 6.0}}, nobody);
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[0].enclosed, 72);
  EXPECT_DOUBLE_EQ(layers[0].voidRatio(), 0.36);
  EXPECT_DOUBLE_EQ(layers[0].openRatio(), (2.0 * 144 - 128) / 288.0);
  EXPECT_EQ(layers[1].enclosed, 0);
  EXPECT_EQ(layers[1].solid, 200);
  EXPECT_EQ(layers[2].voidRatio(), 0.0);
  EXPECT_THROW(poresByLayer(grid, {{2.0, 1.0}}, nobody), InvalidInput);
}

}  // namespace
}  // namespace lamina
