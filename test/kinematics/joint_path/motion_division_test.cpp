// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/joint_path/motion_division.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "support/random_toolpath.hpp"

namespace lamina {
namespace {

Path corner() {
  Path path;
  path.points = {{0, 0, 0}, {10, 0, 0}, {10, 4, 0}};
  path.feed_mm_s = AlongPath<double>(std::vector<double>{10.0, 20.0, 30.0});
  path.bead = AlongPath<Bead>(std::vector<Bead>{{0.3, 0.2}, {0.4, 0.2}, {0.5, 0.2}});
  return path;
}

Toolpath motionDivisionToolpathOf(Path path) {
  Toolpath toolpath;
  toolpath.layers.push_back({0.2, 0.2, {std::move(path)}});
  return toolpath;
}

DividedToolpath inSteps(Path path, double max_step_mm) {
  MotionDivision division;
  division.max_step_mm = max_step_mm;
  return divideMotions(motionDivisionToolpathOf(std::move(path)), division);
}

TEST(MotionDivision, DividesALongMotionIntoEqualStepsOfItsFeedAndBead) {
  const DividedToolpath divided = inSteps(corner(), 5.0);
  const Path& path = divided.toolpath.layers[0].paths[0];
  ASSERT_EQ(path.points.size(), 4U);
  EXPECT_TRUE(path.points[1].isApprox(Point3(5, 0, 0)));
  EXPECT_EQ(path.feed_mm_s.values(), (std::vector<double>{10.0, 20.0, 20.0, 30.0}));
  EXPECT_DOUBLE_EQ(path.bead.at(1).width_mm, 0.4);
  EXPECT_EQ(divided.original[0][0], (std::vector<std::uint32_t>{0, 1, 1, 2}));
  EXPECT_EQ(divided.originalOf({0, 0, 3}).waypoint, 2U);
}

TEST(MotionDivision, KeepsTheProcessValuesOfMotions) {
  Path path = corner();
  path.values.push_back({"laser_power_w", AlongPath<double>(std::vector<double>{0.0, 500.0, 700.0})});
  path.values.push_back({"common", AlongPath<double>(3.0)});
  const DividedToolpath divided = inSteps(path, 5.0);
  const std::vector<ProcessValue>& values = divided.toolpath.layers[0].paths[0].values;
  ASSERT_EQ(values.size(), 2U);
  EXPECT_EQ(values[0].name, "laser_power_w");
  EXPECT_EQ(values[0].value.values(), (std::vector<double>{0.0, 500.0, 500.0, 700.0}));
  EXPECT_EQ(values[1].value.values(), (std::vector<double>{3.0}));
}

TEST(MotionDivision, DividesTheReturnOfAClosedPath) {
  Path path = corner();
  path.is_closed = true;
  const DividedToolpath divided = inSteps(path, 6.0);
  EXPECT_EQ(divided.toolpath.layers[0].paths[0].points.size(), 5U);
  EXPECT_EQ(divided.original[0][0], (std::vector<std::uint32_t>{0, 1, 1, 2, 0}));
  EXPECT_TRUE(divided.toolpath.layers[0].paths[0].points[4].isApprox(Point3(5, 2, 0)));
}

TEST(MotionDivision, TurnsTheNozzleSteadily) {
  Path path = corner();
  path.points.pop_back();
  path.feed_mm_s = 10.0;
  path.bead = Bead{0.4, 0.2};
  const Eigen::Quaterniond tilted(Eigen::AngleAxisd(0.4, Point3::UnitX()) * nozzleDown());
  path.orientation = AlongPath<Eigen::Quaterniond>({nozzleDown(), tilted});
  MotionDivision division;
  division.max_step_mm = 100.0;
  division.max_step_deg = 0.1 * 180.0 / M_PI;
  const DividedToolpath divided = divideMotions(motionDivisionToolpathOf(path), division);
  const Path& steps = divided.toolpath.layers[0].paths[0];
  ASSERT_EQ(steps.points.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(steps.orientation.at(i).angularDistance(nozzleDown()), 0.1 * static_cast<double>(i), 1e-12);
}

TEST(MotionDivision, PutsNoDropsInBetween) {
  Path path = corner();
  path.deposit = Deposit::Drops;
  path.bead = Bead{0.4, 0.2};
  const DividedToolpath divided = inSteps(path, 5.0);
  const Path& steps = divided.toolpath.layers[0].paths[0];
  EXPECT_EQ(steps.bead.at(1).width_mm, 0.0);
  EXPECT_EQ(steps.bead.at(2).width_mm, 0.4);
  EXPECT_NEAR(depositedVolume(steps), depositedVolume(path), 1e-12);
}

TEST(MotionDivision, ChangesNeitherWhatIsDepositedNorWhereTheNozzleGoes) {
  EXPECT_TRUE(rc::check([](std::uint32_t seed) {
    const Toolpath toolpath = test::randomToolpath(seed);
    MotionDivision division;
    division.max_step_mm = 1.5;
    const DividedToolpath divided = divideMotions(toolpath, division);
    validate(divided.toolpath);
    const ToolpathTotals before = totals(toolpath);
    const ToolpathTotals after = totals(divided.toolpath);
    RC_ASSERT(std::abs(after.deposited_mm3 - before.deposited_mm3) < 1e-9 * (1.0 + before.deposited_mm3));
    RC_ASSERT(std::abs(after.deposition_mm - before.deposition_mm) < 1e-9 * (1.0 + before.deposition_mm));
    RC_ASSERT(std::abs(after.travel_mm - before.travel_mm) < 1e-9 * (1.0 + before.travel_mm));
    RC_ASSERT(after.waypoints >= before.waypoints);
  }));
}

}  // namespace
}  // namespace lamina
