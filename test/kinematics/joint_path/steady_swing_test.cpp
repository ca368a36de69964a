// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/progress.hpp"
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"
#include "support/gantry_head.hpp"

namespace lamina {
namespace {

constexpr double kSteadySwingDegree = M_PI / 180.0;

/// Along x, the tool axis inclined by `tilt_deg` towards an azimuth that goes to and fro by 80 deg.
Toolpath wavering(double tilt_deg) {
  Path path;
  path.role = PathRole::OuterWall;
  path.feed_mm_s = 20.0;
  path.bead = Bead{0.5, 0.2};
  std::vector<Eigen::Quaterniond> nozzles;
  for (int i = 0; i <= 200; ++i) {
    path.points.emplace_back(0.5 * i, 0.0, 0.0);
    const double azimuth = 80.0 * kSteadySwingDegree * std::sin(0.3 * i);
    const Eigen::AngleAxisd tilt(-tilt_deg * kSteadySwingDegree,
                                 Point3(-std::sin(azimuth), std::cos(azimuth), 0.0));
    nozzles.push_back(tilt * nozzleDown());
  }
  path.orientation = AlongPath<Eigen::Quaterniond>(std::move(nozzles));
  Toolpath toolpath;
  toolpath.layers.push_back({0.2, 0.2, {path}});
  return toolpath;
}

/// What a machine does on a wavering path.
struct Swing {
  double total = 0.0;          ///< of joint c [rad]
  double tool_axis_off = 0.0;  ///< greatest [rad]
  double tip_off_mm = 0.0;     ///< greatest
};

Swing swingOf(double tilt_deg, double tolerance_deg) {
  const test::GantryHead machine(ToolAxisSpin::Free, 400.0, 60.0);
  const Toolpath toolpath = wavering(tilt_deg);
  JointPathSettings settings;
  settings.swing_tolerance_deg = tolerance_deg;
  NoProgress progress;
  const JointPath path = planJointPath(toolpath, Eigen::Isometry3d::Identity(), machine, settings, progress);
  EXPECT_TRUE(path.isRunnable());
  Swing swing;
  const Path& asked = toolpath.layers[0].paths[0];
  for (std::size_t i = 0; i < path.values.size(); ++i) {
    const Eigen::Isometry3d is = machine.bedFromNozzle(path.values[i]);
    const Point3 tool_axis = asked.orientation.at(i) * Point3::UnitZ();
    const Point3 own = is.linear().col(2);
    swing.tool_axis_off =
        std::max(swing.tool_axis_off, std::atan2(own.cross(tool_axis).norm(), own.dot(tool_axis)));
    swing.tip_off_mm = std::max(swing.tip_off_mm, (is.translation() - asked.points[i]).norm());
    if (i > 0) swing.total += std::abs(path.values[i][3] - path.values[i - 1][3]);
  }
  return swing;
}

TEST(SteadySwing, KeepsTipAndToolAxisWhereNoToleranceIsGiven) {
  const Swing swing = swingOf(2.0, 0.0);
  EXPECT_LT(swing.tool_axis_off, 1e-9);
  EXPECT_LT(swing.tip_off_mm, 1e-9);
}

TEST(SteadySwing, HardlySwingsWhereTheToolAxisLeansLessThanTheTolerance) {
  const Swing swing = swingOf(0.2, 0.5);
  EXPECT_LT(swing.total, 180.0 * kSteadySwingDegree);
  EXPECT_GT(swingOf(0.2, 0.0).total, 1500.0 * kSteadySwingDegree);
  EXPECT_LT(swing.tool_axis_off, 0.5 * kSteadySwingDegree + 1e-9);
  EXPECT_LT(swing.tip_off_mm, 1e-9);
}

TEST(SteadySwing, SwingsLessWithinTheToleranceOfALargerLean) {
  const Swing swing = swingOf(3.0, 1.0);
  EXPECT_LT(swing.total, 0.95 * swingOf(3.0, 0.0).total);
  EXPECT_LT(swing.tool_axis_off, 1.0 * kSteadySwingDegree + 1e-9);
  EXPECT_LT(swing.tip_off_mm, 1e-9);
}

}  // namespace
}  // namespace lamina
