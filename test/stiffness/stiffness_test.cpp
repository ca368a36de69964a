// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/stiffness.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "support/voxel_shapes.hpp"

namespace lamina {
namespace {

StiffnessResult solved(const VoxelGrid& grid, const StiffnessSettings& settings) {
  NoProgress progress;
  return solveStiffness(grid, settings, progress);
}

std::string refusal(const VoxelGrid& grid, const StiffnessSettings& settings) {
  try {
    solved(grid, settings);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

// A cube of 9 mm of polylactide [Vega2023, table 12], pressed by 0.2 mm [Vega2023, section 7.2.2.7].
TEST(Stiffness, ASolidCubeHasTheModulusOfItsMaterialAlongEveryAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    StiffnessSettings settings;
    settings.axis = axis;
    const StiffnessResult result = solved(test::solidBox({30, 30, 30}, 0.3), settings);
    EXPECT_NEAR(result.modulus_mpa, 3861.0, 3.861e-2);
    EXPECT_NEAR(result.force_n, 3861.0 * 81.0 * 0.2 / 9.0, 0.1);
    EXPECT_NEAR(result.imbalance_n, 0.0, 1e-2);
  }
}

TEST(Stiffness, ASolidBoxSpreadsAcrossTheLoadByPoissonsRatio) {
  StiffnessSettings settings;
  settings.residual = 1e-10;
  const StiffnessResult result = solved(test::solidBox({20, 12, 16}, 0.5), settings);
  const ElementLattice& lattice = result.model.lattice;
  const auto low = static_cast<std::size_t>(lattice.nodeAt(0, 6, 16));
  const auto high = static_cast<std::size_t>(lattice.nodeAt(20, 6, 16));
  const double strain = 0.2 / 8.0;
  const std::vector<double>& along_x = result.displacement.along[0];
  EXPECT_NEAR(along_x[high] - along_x[low], 0.35 * strain * 10.0, 1e-8);
  for (const Stress& stress : result.stress) {
    ASSERT_NEAR(stress.zz, -3861.0 * strain, 1e-3);
    ASSERT_NEAR(stress.vonMises(), 3861.0 * strain, 1e-3);
  }
}

// A beam ten times as long as high gives way by shear too (Timoshenko, 6/5 of the mean): E / (1 + 2.4 (1 +
// nu) (h / L)²). Elements of eight nodes are too stiff in bending, by a part that falls with their number
// squared; the lines of contact sink in by less than a hundredth of the deflection.
TEST(Stiffness, ABentBeamApproachesTheClosedForm) {
  const double expected = 3861.0 / (1.0 + 2.4 * 1.35 / 100.0);
  StiffnessSettings settings;
  settings.load = Load::Bending;
  settings.span_mm = 40.0;
  double before = 1e9;
  for (const int n : {4, 8, 16}) {
    const double modulus = solved(test::solidBox({11 * n, n, n}, 4.0 / n), settings).modulus_mpa;
    EXPECT_LT(modulus, before);
    before = modulus;
  }
  EXPECT_NEAR(before, expected, 0.01 * expected);
}

TEST(Stiffness, BendsAlongWhicheverAxesAreAsked) {
  StiffnessSettings settings;
  settings.load = Load::Bending;
  settings.span_mm = 16.0;
  const double upright = solved(test::solidBox({40, 8, 6}, 0.5), settings).modulus_mpa;
  settings.axis = 0;
  EXPECT_NEAR(solved(test::solidBox({6, 40, 8}, 0.5), settings).modulus_mpa, upright, 1e-3 * upright);
  settings.axis = 1;
  EXPECT_NEAR(solved(test::solidBox({8, 6, 40}, 0.5), settings).modulus_mpa, upright, 1e-3 * upright);
}

TEST(Stiffness, ReportsWhatItLeavesOut) {
  VoxelGrid grid({Point3::Zero(), 0.5, {20, 8, 10}});
  for (int k = 0; k < 10; ++k)
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 8; ++i) grid.fill(i, j, k);
  grid.fill(12, 3, 0);
  grid.fill(12, 3, 1);
  grid.fill(16, 4, 5);
  grid.fill(8, 8 - 1, 5);  // part of the block
  grid.fill(9, 8 - 2, 5);  // hangs on it by an edge alone
  const StiffnessResult result = solved(grid, {});
  ASSERT_EQ(result.dropped.size(), 3U);
  EXPECT_EQ(result.dropped[0].elements, 2);
  EXPECT_EQ(result.dropped[0].misses, "top");
  EXPECT_EQ(result.dropped[0].box.low, Point3(6.0, 1.5, 0.0));
  EXPECT_EQ(result.dropped[0].box.high, Point3(6.5, 2.0, 1.0));
  EXPECT_EQ(result.dropped[1].misses, "base, top");
  EXPECT_EQ(result.dropped[2].misses, "base, top");
  EXPECT_EQ(result.model.lattice.elementCount(), 641);
}

TEST(Stiffness, ColumnsApartBearTheLoadTogether) {
  VoxelGrid grid({Point3::Zero(), 0.5, {20, 6, 12}});
  for (int k = 0; k < 12; ++k)
    for (int j = 0; j < 6; ++j)
      for (const int i : {0, 1, 2, 3, 10, 11, 18, 19}) grid.fill(i, j, k);
  const StiffnessResult result = solved(grid, {});
  EXPECT_NEAR(result.modulus_mpa, 3861.0 * 8.0 / 20.0, 0.01);
}

TEST(Stiffness, IsTheSameWhateverTheNumberOfThreads) {
  const VoxelGrid grid = test::gyroid(40, 0.225);
  const StiffnessResult many = solved(grid, {});
  const ThreadLimit limit(1);
  const StiffnessResult one = solved(grid, {});
  EXPECT_EQ(many.iterations, one.iterations);
  EXPECT_EQ(many.force_n, one.force_n);
  EXPECT_EQ(many.displacement.along, one.displacement.along);
}

TEST(Stiffness, NeedsLessThanTwiceTheIterationsForSevenTimesTheElements) {
  const StiffnessResult coarse = solved(test::gyroid(32, 9.0 / 32), {});
  const StiffnessResult fine = solved(test::gyroid(64, 9.0 / 64), {});
  EXPECT_GT(fine.model.lattice.elementCount(), 7 * coarse.model.lattice.elementCount());
  EXPECT_LT(fine.iterations, 2 * coarse.iterations);
  EXPECT_LE(fine.residual, 1e-6);
}

TEST(Stiffness, RefusesWhatItCannotSolve) {
  const VoxelGrid box = test::solidBox({8, 8, 8}, 0.5);
  StiffnessSettings settings;
  settings.material.poissons_ratio = 0.495;
  EXPECT_NE(refusal(box, settings).find("stiffness.poissons_ratio"), std::string::npos);
  settings = {};
  settings.load = Load::Bending;
  EXPECT_NE(refusal(box, settings).find("span_mm is 32"), std::string::npos);
  settings = {};
  settings.residual = 1e-12;
  settings.iterations = 1;
  const std::string unbalanced = refusal(test::gyroid(32, 0.1), settings);
  EXPECT_NE(unbalanced.find("forces are not in balance after 1 iterations"), std::string::npos) << unbalanced;
  EXPECT_NE(unbalanced.find("expected 1e-12 (stiffness.residual) within 1 (stiffness.iterations)"),
            std::string::npos)
      << unbalanced;
  EXPECT_NE(refusal(VoxelGrid({Point3::Zero(), 0.5, {4, 4, 4}}), {}).find("no voxel is solid"),
            std::string::npos);
}

TEST(Stiffness, RefusesWhatDoesNotFitInMemoryAndNamesTheVoxelThatWould) {
  StiffnessSettings settings;
  settings.memory_mb = 1;
  const VoxelGrid grid = test::solidBox({40, 40, 40}, 0.1);
  // 64 000 elements and 68 921 nodes need 12.9 MiB: voxels greater by the third root of that.
  EXPECT_NE(refusal(grid, settings).find("may use 1 MiB, which voxels of 0.2"), std::string::npos)
      << refusal(grid, settings);
}

TEST(Stiffness, ReachesNoTopWhereThereIsAGap) {
  VoxelGrid grid = test::solidBox({6, 6, 9}, 0.5);
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i) grid.open(i, j, 4);
  EXPECT_NE(refusal(grid, {}).find("no part of the solid"), std::string::npos);
}

}  // namespace
}  // namespace lamina
