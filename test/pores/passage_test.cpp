// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/pores/passage.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>

#include "lamina/pores/pore_groups.hpp"
#include "pores/voxel_patterns.hpp"

namespace lamina {
namespace {

using Voxel = std::array<int, 3>;

/// The reached voxels of each layer, voxel by voxel as defined.
std::vector<std::set<Voxel>> reachedOneByOne(const VoxelGrid& pores, int axis, int step) {
  const auto& count = pores.frame().count;
  const auto a = static_cast<std::size_t>(axis);
  const int layers = count[a];
  std::vector<std::set<Voxel>> reached(static_cast<std::size_t>(layers));
  for (int n = 0; n < layers; ++n) {
    const int layer = step > 0 ? n : layers - 1 - n;
    for (int k = 0; k < count[2]; ++k)
      for (int j = 0; j < count[1]; ++j)
        for (int i = 0; i < count[0]; ++i) {
          const Voxel voxel{i, j, k};
          if (voxel[a] != layer || !pores.isSolid(i, j, k)) continue;
          bool is_reached = n == 0;
          if (n > 0)
            for (const Voxel& from : reached[static_cast<std::size_t>(layer - step)]) {
              int farthest = 0;
              for (std::size_t b = 0; b < 3; ++b)
                if (b != a) farthest = std::max(farthest, std::abs(from[b] - voxel[b]));
              is_reached = is_reached || farthest <= 1;
            }
          if (is_reached) reached[static_cast<std::size_t>(layer)].insert(voxel);
        }
  }
  return reached;
}

TEST(PassageTest, AStraightChannelIsWhatOfTheFaceItTakes) {
  VoxelGrid grid = solidBlock(10, 10, 10);
  openBox(grid, {{4, 4, 0}, {6, 6, 10}});
  const Passages found = passages(inverted(grid));
  EXPECT_DOUBLE_EQ(found.along[2].epci_forward_percent, 4.0);
  EXPECT_DOUBLE_EQ(found.along[2].mecsi_percent, 4.0);
  EXPECT_EQ(found.along[0].epci_forward_percent, 0.0);
  EXPECT_NEAR(found.epciPercent(), 4.0 / 3.0, 1e-12);
  EXPECT_NEAR(found.mecsiPercent(), 4.0 / 3.0, 1e-12);
}

TEST(PassageTest, AWaySpreadsByOneVoxelALayerAndMayLeadNowhereBack) {
  // A funnel of 1, 3 and 5 voxels, and a pocket at the wide end which cannot be reached from the narrow one.
  VoxelGrid grid = solidBlock(9, 9, 3);
  openBox(grid, {{4, 4, 0}, {5, 5, 1}});
  openBox(grid, {{3, 3, 1}, {6, 6, 2}});
  openBox(grid, {{2, 2, 2}, {7, 7, 3}});
  openBox(grid, {{0, 0, 2}, {1, 1, 3}});
  const Passage along = passageAlong(inverted(grid), 2);
  EXPECT_DOUBLE_EQ(along.epci_forward_percent, 2500.0 / 81.0);
  EXPECT_DOUBLE_EQ(along.epci_backward_percent, 100.0 / 81.0);
  EXPECT_DOUBLE_EQ(along.mecsi_percent, 100.0 / 81.0);
}

TEST(PassageTest, IsWhatItsDefinitionSaysOfAnyGridAlongAnyAxis) {
  EXPECT_TRUE(rc::check([] {
    const VoxelGrid pores = arbitraryGrid();
    for (int axis = 0; axis < 3; ++axis) {
      const auto forward = reachedOneByOne(pores, axis, 1);
      const auto backward = reachedOneByOne(pores, axis, -1);
      std::size_t narrowest = forward[0].size();
      for (std::size_t layer = 0; layer < forward.size(); ++layer)
        narrowest = std::min<std::size_t>(
            narrowest, std::count_if(forward[layer].begin(), forward[layer].end(),
                                     [&](const Voxel& voxel) { return backward[layer].count(voxel) != 0; }));
      const auto& count = pores.frame().count;
      const double to_percent =
          100.0 * count[static_cast<std::size_t>(axis)] / static_cast<double>(pores.frame().voxelCount());
      const Passage found = passageAlong(pores, axis);
      const auto isNear = [](double a, double b) { return std::abs(a - b) < 1e-9; };
      RC_ASSERT(isNear(found.epci_forward_percent, to_percent * static_cast<double>(forward.back().size())));
      RC_ASSERT(
          isNear(found.epci_backward_percent, to_percent * static_cast<double>(backward.front().size())));
      RC_ASSERT(isNear(found.mecsi_percent, to_percent * static_cast<double>(narrowest)));
    }
  }));
}

}  // namespace
}  // namespace lamina
