// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/emulated_machine/machine_deposit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace {

using lamina::Bead;
using lamina::DepositModel;
using lamina::Point3;

constexpr double kWidth = 0.4;
constexpr double kHeight = 0.2;
const Eigen::Vector3d kDown(0, 0, -1);

std::unique_ptr<lamina::MachineDeposit> bareBedOf(const std::string& machine, DepositModel model) {
  lamina::EmulatedMachineSettings settings;
  settings.deposit_model = model;
  return bareBed(lamina::buildSpaceByName(machine), kDown, settings);
}

/// A solid layer of 10 mm x 5 mm.
void layLayer(lamina::MachineDeposit& deposit, double z) {
  const Bead bead{kWidth, kHeight};
  for (double y = 100.0; y < 105.0; y += planWidth(bead))
    deposit.lay({{100, y, z}, {110, y, z}, kDown, kDown, 10.0 * crossSection(bead)}, {});
}

class MachineDepositModels : public testing::TestWithParam<DepositModel> {};

TEST_P(MachineDepositModels, ASolidBlockIsAsHighAsItsNozzleWas) {
  const auto deposit = bareBedOf("cartesian_gantry", GetParam());
  EXPECT_EQ(deposit->highest(), 0.0);
  EXPECT_TRUE(deposit->points().empty());
  for (int layer = 1; layer <= 5; ++layer) layLayer(*deposit, kHeight * layer);
  EXPECT_NEAR(deposit->highest(), 1.0, 1e-6);
  const lamina::HeightSource surface = deposit->surface();
  double sum = 0.0;
  int cells = 0;
  for (int row = 0; row < surface.grid.rows; ++row)
    for (int column = 0; column < surface.grid.columns; ++column) {
      const lamina::Point2 at = surface.grid.centre(column, row) - lamina::Point2(100, 100);
      if (at.x() < 1.0 || at.x() > 9.0 || at.y() < 1.0 || at.y() > 4.0) continue;
      sum += surface.height(column, row) - 1.0;
      ++cells;
    }
  ASSERT_GT(cells, 2000);
  EXPECT_NEAR(sum / cells, 0.0, 0.01) << "a twentieth of a layer";
  for (const Point3& point : deposit->points()) {
    EXPECT_LE(point.z(), 1.0 + 1e-6);
    EXPECT_NEAR(point.x(), 105.0, 5.6);
    EXPECT_NEAR(point.y(), 102.5, 3.2);
  }
}

INSTANTIATE_TEST_SUITE_P(All, MachineDepositModels,
                         testing::Values(DepositModel::Voxels, DepositModel::Heights), [](const auto& model) {
                           return model.param == DepositModel::Voxels ? "Voxels" : "Heights";
                         });

TEST(MachineDeposit, InVoxelsAStrandInTheAirLiesAlongTheToolAxis) {
  const auto deposit = bareBedOf("gantry_45", DepositModel::Auto);
  const double radius = 0.3;
  const Eigen::Vector3d tool_axis = Eigen::Vector3d(0, 1, -1).normalized();
  const Point3 start(100, 100, 10);
  deposit->lay({start, start + Point3(10, 0, 0), tool_axis, tool_axis, 10.0 * M_PI * radius * radius}, {});
  const std::vector<Point3> points = deposit->points();
  ASSERT_GT(points.size(), 500U);
  Point3 middle = Point3::Zero();
  for (const Point3& point : points) middle += point / static_cast<double>(points.size());
  EXPECT_LT((middle - (start + Point3(5, 0, 0) + radius * tool_axis)).norm(), 0.1);
  for (const Point3& point : points) EXPECT_GT(point.z(), 9.0) << "nothing hangs down to the bed";
}

TEST(MachineDeposit, OnABeltAutoKeepsHeights) {
  const auto deposit = bareBedOf("belt_45", DepositModel::Auto);
  const Eigen::Vector3d tool_axis = Eigen::Vector3d(0, 1, -1).normalized();
  deposit->lay({{100, 50, 0.35}, {110, 50, 0.35}, tool_axis, tool_axis, 1.0}, {});
  const std::vector<Point3> points = deposit->points();
  ASSERT_FALSE(points.empty());
  const auto higher = [](const Point3& a, const Point3& b) { return a.z() < b.z(); };
  EXPECT_NEAR(std::max_element(points.begin(), points.end(), higher)->z(), deposit->highest(), 1e-9);
}

/// Heights of a wall of five beads above (100, 100), as the settings let it stand.
std::vector<double> wallOf(const lamina::EmulatedMachineSettings& settings) {
  const auto deposit = bareBed(lamina::buildSpaceByName("cartesian_gantry"), kDown, settings);
  const Bead bead{kWidth, kHeight};
  for (int layer = 1; layer <= 5; ++layer) {
    const double z = kHeight * layer;
    deposit->lay({{100, 100, z}, {130, 100, z}, kDown, kDown, 30.0 * crossSection(bead)},
                 {10.0 * layer, 10.0 * layer + 3.0});
    deposit->endBead();
  }
  const lamina::HeightSource surface = deposit->surface();
  std::vector<double> heights;
  for (int row = 0; row < surface.grid.rows; ++row)
    for (int column = 0; column < surface.grid.columns; ++column) {
      const lamina::Point2 off = surface.grid.centre(column, row) - lamina::Point2(115, 100);
      if (std::abs(off.x()) < 16.0 && std::abs(off.y()) < 1.0) heights.push_back(surface.height(column, row));
    }
  return heights;
}

double greatest(const std::vector<double>& heights) {
  return *std::max_element(heights.begin(), heights.end());
}

TEST_P(MachineDepositModels, WithoutDisturbanceIsTheSameToTheLastBit) {
  lamina::EmulatedMachineSettings plain;
  plain.deposit_model = GetParam();
  lamina::EmulatedMachineSettings idle = plain;
  idle.plant.seed = 7;
  idle.plant.end_mm = 3.0;
  idle.plant.clog_at_layer = 2;
  idle.grown.bead_width_mm = 2.0;
  EXPECT_EQ(wallOf(idle), wallOf(plain));
}

TEST_P(MachineDepositModels, OfADisturbedProcessGrowsAsItDoes) {
  lamina::EmulatedMachineSettings settings;
  settings.deposit_model = GetParam();
  settings.plant.gain = 0.9;
  EXPECT_NEAR(greatest(wallOf(settings)), 0.9 * 5 * kHeight, 1e-9);
  settings.grown.bead_width_mm = 2.0 * planWidth(Bead{kWidth, kHeight});
  EXPECT_NEAR(greatest(wallOf(settings)), 0.9 * 5 * 0.5 * kHeight, 1e-9);
  settings.plant = {};
  settings.plant.wear = 0.5;
  settings.grown.bead_width_mm = 0.0;
  settings.grown.layers = 5;
  EXPECT_NEAR(greatest(wallOf(settings)), (5.0 - 0.5 * (0.0 + 0.2 + 0.4 + 0.6 + 0.8)) * kHeight, 1e-9)
      << "deposit.layers, deposit.bead_width_mm of the first bead";
}

/// A wall of five beads along x, stacked at 45 deg from (100, 100) on the bed.
TEST(MachineDeposit, OfADisturbedProcessGrowsAgainstToolAxesThatLean) {
  lamina::EmulatedMachineSettings settings;
  settings.plant.gain = 0.9;
  settings.grown.bead_width_mm = planWidth(Bead{kWidth, kHeight});
  const Eigen::Vector3d tool_axis = Eigen::Vector3d(0, 1, -1).normalized();
  const auto deposit = bareBed(lamina::buildSpaceByName("gantry_45"), tool_axis, settings);
  const Bead bead{kWidth, kHeight};
  for (int layer = 1; layer <= 5; ++layer) {
    const Point3 start = Point3(100, 100, 0) - kHeight * layer * tool_axis;
    deposit->lay({start, start + Point3(30, 0, 0), tool_axis, tool_axis, 30.0 * crossSection(bead)}, {});
    deposit->endBead();
  }
  const std::vector<Point3> points = deposit->points();
  ASSERT_FALSE(points.empty());
  const auto height = [&](const Point3& at) { return -tool_axis.dot(at - Point3(100, 100, 0)); };
  const double top = height(*std::max_element(
      points.begin(), points.end(), [&](const Point3& a, const Point3& b) { return height(a) < height(b); }));
  // The cells of the bed under the first bead do not lie alike on both sides of its middle.
  EXPECT_NEAR(top, 0.9 * 5 * kHeight, 0.5 * settings.deposit_cell_mm);
  for (const Point3& at : points) {
    EXPECT_GT(at.z(), -1e-9);
    EXPECT_NEAR(at.x(), 115.0, 15.2);
    EXPECT_NEAR(at.dot(Eigen::Vector3d(0, 1, 1).normalized()), 100.0 * std::sqrt(0.5), 0.5 * kWidth + 0.01);
  }
  EXPECT_NEAR(deposit->bedFromSurface().linear().col(2).dot(tool_axis), -1.0, 1e-12);
}

TEST(MachineDeposit, OfALeaningToolAxisBreaksNothingOff) {
  lamina::EmulatedMachineSettings settings;
  settings.plant.detach_at_layer = 3;
  const Eigen::Vector3d leaning = Eigen::Vector3d(0, 1, -1).normalized();
  try {
    bareBed(lamina::buildSpaceByName("gantry_45"), leaning, settings);
    FAIL() << "expected to be refused";
  } catch (const lamina::InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("leans by 45 deg"), std::string::npos) << error.what();
  }
}

}  // namespace
