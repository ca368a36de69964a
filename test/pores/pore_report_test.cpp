// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/pores/pore_report.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "pores/voxel_patterns.hpp"

namespace lamina {
namespace {

PoreReport reported(const VoxelGrid& solid) {
  NoProgress nobody;
  return reportPores(solid, nobody);
}

TEST(PoreReportTest, AStraightChannelIsOpenAndJoinsOppositeFaces) {
  VoxelGrid grid = solidBlock(10, 10, 10);
  openBox(grid, {{4, 4, 0}, {6, 6, 10}});
  const PoreReport report = reported(grid);
  EXPECT_DOUBLE_EQ(report.porosity_percent, 4.0);
  EXPECT_DOUBLE_EQ(report.joining_opposite.volume_percent, 4.0);
  EXPECT_DOUBLE_EQ(report.joining_two.volume_percent, 4.0);
  EXPECT_NEAR(report.passages.epciPercent(), 1.333, 5e-4);
  EXPECT_NEAR(report.passages.mecsiPercent(), 1.333, 5e-4);
  EXPECT_NEAR(report.joining_passages.epciPercent(), 4.0 / 3.0, 1e-12);
}

TEST(PoreReportTest, AChannelRoundTheCornerJoinsTwoFacesThatAreNotOpposite) {
  // From the face x = 0 along x, then up to the face of greatest z.
  VoxelGrid grid = solidBlock(10, 10, 10);
  openBox(grid, {{0, 4, 4}, {6, 6, 6}});
  openBox(grid, {{4, 4, 6}, {6, 6, 10}});
  const PoreReport report = reported(grid);
  EXPECT_EQ(report.joining_opposite.volume_percent, 0.0);
  EXPECT_DOUBLE_EQ(report.joining_two.volume_percent, 4.0);
  EXPECT_EQ(report.joining_passages.epciPercent(), 0.0);
}

TEST(PoreReportTest, AClosedVoidJoinsNothing) {
  VoxelGrid grid = solidBlock(10, 10, 10);
  openBox(grid, {{3, 3, 3}, {7, 7, 7}});
  const PoreReport report = reported(grid);
  EXPECT_DOUBLE_EQ(report.porosity_percent, 6.4);
  EXPECT_EQ(report.joining_opposite.groups, 0);
  EXPECT_EQ(report.joining_two.volume_percent, 0.0);
  EXPECT_EQ(report.all.groups, 1);
  EXPECT_NEAR(report.all.mean_diameter_mm, std::cbrt(6.0 * 64.0 / M_PI), 1e-12);
  EXPECT_NEAR(report.all.ellipsoid_mm[2].mean, 4.0 * std::sqrt(5.0 / 3.0), 1e-12);
  EXPECT_NEAR(report.all.ellipsoid_mm[0].deviation, 0.0, 1e-6);
}

TEST(PoreReportTest, SpreadsAreThoseOfThePopulation) {
  VoxelGrid grid = solidBlock(20, 10, 10);
  openBox(grid, {{2, 2, 2}, {4, 4, 4}});
  openBox(grid, {{10, 2, 2}, {14, 6, 6}});
  const PoreReport report = reported(grid);
  EXPECT_EQ(report.all.groups, 2);
  EXPECT_NEAR(report.all.ellipsoid_mm[0].mean, 3.0 * std::sqrt(5.0 / 3.0), 1e-12);
  EXPECT_NEAR(report.all.ellipsoid_mm[0].deviation, std::sqrt(5.0 / 3.0), 1e-9);
}

TEST(PoreReportTest, NothingOpenHasNoPores) {
  const PoreReport report = reported(solidBlock(65, 3, 3));
  EXPECT_EQ(report.porosity_percent, 0.0);
  EXPECT_EQ(report.all.mean_diameter_mm, 0.0);
}

TEST(PoreReportTest, ShareByShareOneIsPartOfTheOther) {
  EXPECT_TRUE(rc::check([] {
    const PoreReport report = reported(arbitraryGrid());
    RC_ASSERT(report.joining_opposite.voxels <= report.joining_two.voxels);
    RC_ASSERT(report.joining_two.voxels <= report.all.voxels);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Passage& all = report.passages.along[axis];
      const Passage& joining = report.joining_passages.along[axis];
      RC_ASSERT(joining.epci_forward_percent <= all.epci_forward_percent + 1e-9);
      RC_ASSERT(joining.mecsi_percent <= all.mecsi_percent + 1e-9);
      RC_ASSERT(all.mecsi_percent <= all.epci_forward_percent + 1e-9);
      RC_ASSERT(all.mecsi_percent <= all.epci_backward_percent + 1e-9);
    }
  }));
}

}  // namespace
}  // namespace lamina
