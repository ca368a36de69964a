// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/pores/pore_groups.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <queue>

#include "lamina/base/parallel.hpp"
#include "pores/voxel_patterns.hpp"

namespace lamina {
namespace {

using PoreGroupsVoxel = std::array<int, 3>;

/// Group numbers by flooding, in the order of the first voxels.
std::map<PoreGroupsVoxel, int> flooded(const VoxelGrid& pores) {
  const auto& count = pores.frame().count;
  std::map<PoreGroupsVoxel, int> group;
  int groups = 0;
  for (int k = 0; k < count[2]; ++k)
    for (int j = 0; j < count[1]; ++j)
      for (int i = 0; i < count[0]; ++i) {
        if (!pores.isSolid(i, j, k) || group.count({i, j, k}) != 0) continue;
        std::queue<PoreGroupsVoxel> front({PoreGroupsVoxel{i, j, k}});
        group[{i, j, k}] = groups;
        while (!front.empty()) {
          const PoreGroupsVoxel at = front.front();
          front.pop();
          for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
              PoreGroupsVoxel next = at;
              next[axis] += step;
              if (pores.isSolid(next[0], next[1], next[2]) && group.emplace(next, groups).second)
                front.push(next);
            }
        }
        ++groups;
      }
  return group;
}

PoreGroups labelled(const VoxelGrid& pores) {
  NoProgress nobody;
  return labelPores(pores, nobody);
}

TEST(PoreGroupsTest, AreThoseOfFloodingWhateverTheThreads) {
  EXPECT_TRUE(rc::check([] {
    const VoxelGrid pores = arbitraryGrid();
    const std::map<PoreGroupsVoxel, int> expected = flooded(pores);
    const PoreGroups found = labelled(pores);
    std::size_t voxels = 0;
    for (const PoreRun& run : found.runs)
      for (int i = run.low; i < run.high; ++i, ++voxels)
        RC_ASSERT(expected.at({i, run.j, run.k}) == static_cast<int>(run.group));
    RC_ASSERT(voxels == expected.size());
    const ThreadLimit alone(1);
    const PoreGroups again = labelled(pores);
    RC_ASSERT(again.groups.size() == found.groups.size());
    for (std::size_t g = 0; g < found.groups.size(); ++g) {
      RC_ASSERT(again.groups[g].voxels == found.groups[g].voxels);
      RC_ASSERT(again.groups[g].axes == found.groups[g].axes);
    }
  }));
}

TEST(PoreGroupsTest, GiveBackTheVoxelsTheyWereMadeFrom) {
  EXPECT_TRUE(rc::check([] {
    const VoxelGrid pores = arbitraryGrid();
    const VoxelGrid back = voxelsOf(labelled(pores), [](const PoreGroup&) { return true; });
    const auto& count = pores.frame().count;
    for (int k = 0; k < count[2]; ++k)
      for (int j = 0; j < count[1]; ++j)
        for (int w = 0; w < pores.wordCount(); ++w) RC_ASSERT(back.word(w, j, k) == pores.word(w, j, k));
    RC_ASSERT(inverted(pores).solidCount() == pores.frame().voxelCount() - pores.solidCount());
  }));
}

TEST(PoreGroupsTest, ReportWhichFacesTheyTouch) {
  VoxelGrid pores({Point3::Zero(), 1.0, {70, 5, 5}});
  for (int i = 0; i < 70; ++i) pores.fill(i, 2, 0);
  const PoreGroups found = labelled(pores);
  ASSERT_EQ(found.groups.size(), 1U);
  EXPECT_EQ(found.groups[0].faces,
            faceBit(0, AxisEnd::Low) | faceBit(0, AxisEnd::High) | faceBit(2, AxisEnd::Low));
  EXPECT_TRUE(found.groups[0].joinsAlong(0));
  EXPECT_FALSE(found.groups[0].joinsAlong(2));
}

TEST(PoreGroupsTest, ABoxHasTheAxesOfTheEllipsoidOfItsMoments) {
  // The variance of a box along a side is side² / 12, so that 2 sqrt(5 lambda) is side sqrt(5 / 3).
  VoxelGrid pores({Point3::Zero(), 1.0, {100, 40, 30}});
  for (int k = 3; k < 9; ++k)
    for (int j = 5; j < 25; ++j)
      for (int i = 60; i < 72; ++i) pores.fill(i, j, k);
  const PoreGroups found = labelled(pores);
  ASSERT_EQ(found.groups.size(), 1U);
  EXPECT_NEAR(found.groups[0].axes[0], 20.0 * std::sqrt(5.0 / 3.0), 1e-9);
  EXPECT_NEAR(found.groups[0].axes[1], 12.0 * std::sqrt(5.0 / 3.0), 1e-9);
  EXPECT_NEAR(found.groups[0].axes[2], 6.0 * std::sqrt(5.0 / 3.0), 1e-9);
  EXPECT_NEAR(found.groups[0].equivalentDiameter(), std::cbrt(6.0 * 1440.0 / M_PI), 1e-9);
}

TEST(PoreGroupsTest, ABallHasItsDiameterAsAxes) {
  const int radius = 20;
  VoxelGrid pores({Point3::Zero(), 1.0, {45, 45, 45}});
  for (int k = 0; k < 45; ++k)
    for (int j = 0; j < 45; ++j)
      for (int i = 0; i < 45; ++i)
        if ((Point3(i, j, k) - Point3(22, 22, 22)).norm() <= radius) pores.fill(i, j, k);
  const PoreGroups found = labelled(pores);
  ASSERT_EQ(found.groups.size(), 1U);
  for (const double axis : found.groups[0].axes) EXPECT_NEAR(axis, 2.0 * radius, 0.4);
}

TEST(PoreGroupsTest, StopWhenCancelled) {
  class Cancelling final : public Progress {
   public:
    void report(const std::string&, double) override {}
    bool isCancelled() const override { return true; }
  };
  Cancelling cancelled;
  EXPECT_ANY_THROW(labelPores(solidBlock(3, 3, 3), cancelled));
}

}  // namespace
}  // namespace lamina
