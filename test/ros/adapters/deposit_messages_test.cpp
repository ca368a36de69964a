// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/deposition_simulator/deposit_messages.hpp"

#include <gtest/gtest.h>
#include <ros/time.h>

#include "job/settings/setting_probe.hpp"

namespace lamina {
namespace {

/// A solid cube of that many voxels a side.
VoxelGrid cube(int side) {
  VoxelGrid grid(VoxelFrame{Point3::Zero(), 0.1, {side, side, side}});
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) grid.fill(i, j, k);
  return grid;
}

std::uint32_t pointsShown(const test::SettingTexts& set) {
  ros::Time::init();
  return depositedCloud(cube(36), test::settingsWith<DepositionSimulatorSettings>(set).shown).width;
}

TEST(DepositMessages, ACloudHoldsTheSurfaceAsFinelyAsItsPointsAllow) {
  EXPECT_EQ(pointsShown({}), 36U * 36U * 36U - 34U * 34U * 34U);
  // Cubes of 2 voxels would be 18^3 - 16^3 = 1736, of 3 voxels they are:
  EXPECT_EQ(pointsShown({{"shown.points", "1000"}}), 12U * 12U * 12U - 10U * 10U * 10U);
}

TEST(DepositMessages, ASummaryStatesVolumesInCubicMetres) {
  DepositSummary summary;
  summary.totals.extruded_mm3 = 23.0;
  summary.totals.deposited_mm3 = 11.0;
  summary.totals.excess_mm3 = 5.0;
  summary.totals.outside_mm3 = 7.0;
  const lamina_msgs::DepositionSummary message = toMessage(summary);
  EXPECT_DOUBLE_EQ(message.extruded_volume, 23e-9);
  EXPECT_DOUBLE_EQ(message.model_volume, 11e-9);
  EXPECT_DOUBLE_EQ(message.excess_volume, 5e-9);
  EXPECT_DOUBLE_EQ(message.outside_volume, 7e-9);
}

}  // namespace
}  // namespace lamina
