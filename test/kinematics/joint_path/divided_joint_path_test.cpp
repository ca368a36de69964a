// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/joint_path/divided_joint_path.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/gantry_head.hpp"

namespace lamina {
namespace {

/// A motion on which the tool axis turns from straight down to 60 deg.
Toolpath turning() {
  Path path;
  path.role = PathRole::OuterWall;
  path.points = {{0, 0, 0}, {40, 0, 0}};
  path.orientation = AlongPath<Eigen::Quaterniond>(
      {nozzleDown(), Eigen::AngleAxisd(M_PI / 3.0, Point3::UnitX()) * nozzleDown()});
  path.bead = Bead{0.4, 0.2};
  path.feed_mm_s = 20.0;
  Toolpath toolpath;
  toolpath.layers.push_back({0.2, 0.2, {path}});
  return toolpath;
}

// Linear joints that go steadily while an arm of 100 mm turns by t leave out the arc's rise of
// 100 (1 - cos(t / 2)).
TEST(DividedJointPath, MeasuresHowFarSteadyJointsLeaveAMotion) {
  const test::GantryHead machine(ToolAxisSpin::Free, 200.0, 100.0);
  NoProgress progress;
  const JointPath path =
      planJointPath(turning(), Eigen::Isometry3d::Identity(), machine, JointPathSettings(), progress);
  const auto deviations = motionDeviations(path, turning(), machine, JointPathSettings());
  ASSERT_EQ(deviations.size(), 2U);
  EXPECT_EQ(deviations[0].tip_mm, 0.0);
  EXPECT_NEAR(deviations[1].tip_mm, 100.0 * (1.0 - std::cos(M_PI / 6.0)), 1e-6);
  EXPECT_NEAR(deviations[1].tool_axis, 0.0, 1e-9);
}

TEST(DividedJointPath, DividesUntilTheToleranceIsKept) {
  const test::GantryHead machine(ToolAxisSpin::Free, 200.0, 100.0);
  NoProgress progress;
  JointPathSettings settings;
  settings.division.tip_tolerance_mm = 0.005;
  const DividedJointPath found =
      planDividedJointPath(turning(), Eigen::Isometry3d::Identity(), machine, settings, progress);
  EXPECT_TRUE(found.joints.isRunnable());
  EXPECT_LE(found.greatest.tip_mm, 0.005);
  // A step of t leaves 100 (1 - cos(t / 2)) = 0.005: 1.15 deg, so 60 deg take 53 steps at least.
  EXPECT_GE(found.divided.toolpath.layers[0].paths[0].points.size(), 54U);
  EXPECT_LE(found.divided.toolpath.layers[0].paths[0].points.size(), 120U);
  EXPECT_EQ(found.joints.at.size(), found.divided.toolpath.layers[0].paths[0].points.size());
}

// On the way into the singularity and out of it the joint leads the tip already, 5.7 mm from its axis: of 80
// deg none may be left for there, where each finer step would have all of it at its end again.
TEST(DividedJointPath, TurnsATableWhereTheToolAxisIsAlongItsAxisHoweverShortThatIs) {
  const auto head = kinematicModelByName("five_axis_head_table");
  const auto leaning = [](double azimuth_deg, double tilt_deg) {
    const Eigen::AngleAxisd azimuth(azimuth_deg * M_PI / 180.0, Point3::UnitZ());
    const Eigen::AngleAxisd tilt(tilt_deg * M_PI / 180.0, azimuth * Point3::UnitY());
    return Eigen::Quaterniond(tilt * azimuth) * nozzleDown();
  };
  Path path;
  path.role = PathRole::OuterWall;
  path.points = {{5.5, -2.0, 8.0}, {5.7, -1.0, 8.0}, {5.7, -0.07, 8.0},
                 {5.7, 0.07, 8.0}, {5.7, 1.0, 8.0},  {5.5, 2.0, 8.0}};
  path.orientation = AlongPath<Eigen::Quaterniond>({leaning(-40.0, 2.0), leaning(-40.0, 1.0), nozzleDown(),
                                                    nozzleDown(), leaning(40.0, 1.0), leaning(40.0, 2.0)});
  path.bead = Bead{1.6, 0.8};
  path.feed_mm_s = 30.0;
  Toolpath toolpath;
  toolpath.layers.push_back({8.0, 0.8, {path}});
  NoProgress progress;
  const DividedJointPath found =
      planDividedJointPath(toolpath, Eigen::Isometry3d::Identity(), *head, JointPathSettings(), progress);
  ASSERT_TRUE(found.joints.isRunnable()) << found.joints.faults[0].reason;
  EXPECT_LE(found.greatest.tip_mm, JointPathSettings().division.tip_tolerance_mm);
}

// Rungs that are kept from one division to the next are those that would be solved again.
TEST(DividedJointPath, IsThePathOfTheDividedToolpathPlannedByItself) {
  const auto arm = kinematicModelByName("irb_4600");
  NoProgress progress;
  JointPathSettings settings;
  settings.division.tip_tolerance_mm = 0.001;
  const DividedJointPath found =
      planDividedJointPath(turning(), Eigen::Isometry3d::Identity(), *arm, settings, progress);
  const Toolpath& divided = found.divided.toolpath;
  EXPECT_GT(divided.layers[0].paths[0].points.size(), turning().layers[0].paths[0].points.size());
  const JointPath alone = planJointPath(divided, Eigen::Isometry3d::Identity(), *arm, settings, progress);
  EXPECT_TRUE(alone.isRunnable());
  ASSERT_EQ(found.joints.values.size(), alone.values.size());
  for (std::size_t i = 0; i < alone.values.size(); ++i)
    EXPECT_EQ(found.joints.values[i], alone.values[i]) << i;
}

}  // namespace
}  // namespace lamina
