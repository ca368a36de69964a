// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/followed_deposit.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kVoxel = 1e-3;  // mm3

double inGrid(const FollowedDeposit& followed) { return followed.deposit().grid().solidVolume(); }

void runAlong(FollowedDeposit& followed, const Point3& from, const Point3& to) {
  for (int i = 0; i <= 100; ++i) followed.observe(from + (to - from) * (i / 100.0));
}

TEST(FollowedDeposit, LaysWhatTheNozzleHasPassedAndInTheEndAll) {
  const Toolpath toolpath = test::twoLayers();
  FollowedDeposit followed(toolpath, {}, {});
  EXPECT_NEAR(followed.plannedVolume(), totals(toolpath).deposited_mm3, 1e-9);
  const double per_mm = crossSection({0.4, 0.2});
  runAlong(followed, {0, 0, 0.2}, {10, 0, 0.2});
  runAlong(followed, {10, 0, 0.2}, {10, 5, 0.2});
  EXPECT_NEAR(inGrid(followed), 15.0 * per_mm, 0.3 * per_mm);
  runAlong(followed, {10, 5, 0.2}, {10, 10, 0.2});
  runAlong(followed, {10, 10, 0.2}, {0, 10, 0.2});
  runAlong(followed, {0, 10, 0.2}, {0, 0, 0.2});
  EXPECT_FALSE(followed.isComplete());
  EXPECT_NEAR(inGrid(followed), 40.0 * per_mm, 0.3 * per_mm);
  runAlong(followed, {0, 0, 0.2}, {0, 0, 0.4});
  runAlong(followed, {0, 0, 0.4}, {10, 0, 0.4});
  EXPECT_TRUE(followed.isComplete());
  EXPECT_NEAR(followed.deposit().totals().extruded_mm3, followed.plannedVolume(), 1e-9);
  EXPECT_NEAR(inGrid(followed), followed.plannedVolume(), kVoxel);
  EXPECT_NEAR(followed.deposit().highest(), 0.4, 1e-6);
}

TEST(FollowedDeposit, LaysADropWhereTheNozzleHasBeen) {
  Path drops = test::straightPath({0, 0, 1}, {4, 0, 1});
  drops.deposit = Deposit::Drops;
  drops.bead = Bead{1.0, 1.0};
  drops.points = {{0, 0, 1}, {2, 0, 1}, {4, 0, 1}};
  Path last = drops;
  last.points = {{4, 0, 1}};
  FollowedDeposit followed({"drops", {{1.0, 1.0, {drops, last}}}}, {}, {});
  const double drop = 0.25 * M_PI;
  EXPECT_NEAR(followed.plannedVolume(), 4.0 * drop, 1e-9);
  runAlong(followed, {0, 0, 1}, {1, 0, 1});
  EXPECT_NEAR(inGrid(followed), drop, kVoxel);
  runAlong(followed, {1, 0, 1}, {3, 0, 1});
  EXPECT_NEAR(inGrid(followed), 2.0 * drop, 2.0 * kVoxel);
  runAlong(followed, {3, 0, 1}, {4, 0, 1});
  EXPECT_TRUE(followed.isComplete());
  EXPECT_NEAR(inGrid(followed), 4.0 * drop, 2.0 * kVoxel);
}

TEST(FollowedDeposit, LaysNoSkirtUnlessAsked) {
  Toolpath toolpath = test::twoLayers();
  toolpath.layers[0].paths[0].role = PathRole::Skirt;
  DepositionSettings with_skirt;
  with_skirt.are_build_aids_deposited = true;
  const double per_mm = crossSection({0.4, 0.2});
  EXPECT_NEAR(FollowedDeposit(toolpath, {}, {}).plannedVolume(), 10.0 * per_mm, 1e-9);
  EXPECT_NEAR(FollowedDeposit(toolpath, with_skirt, {}).plannedVolume(), 50.0 * per_mm, 1e-9);
}

TEST(FollowedDeposit, RefusesWhatDoesNotFitIntoMemory) {
  DepositionSettings fine;
  fine.voxel_mm = 0.001;
  fine.memory_limit_mb = 1.0;
  EXPECT_THROW(FollowedDeposit(test::twoLayers(), fine, {}), InvalidInput);
}

}  // namespace
}  // namespace lamina
