// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Arms of five axes: the tip and the tool axis of a pose.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "lamina/base/error.hpp"
#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/arm/abb_configuration.hpp"
#include "lamina/kinematics/description_files/robot_report.hpp"
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"
#include "support/arms.hpp"

namespace lamina {
namespace {

constexpr int kRandomPoses = 2000;
constexpr double kAwayFromSingular = 0.02;  // sine

/// An arm whose axes 2, 3 and 4 are parallel, axis 5 along the hand, and a nozzle beyond it.
/// @param tilt_rad  of the nozzle from axis 5
std::string fiveAxisArm(double tilt_rad) {
  const std::array<std::string, 5> origins = {"0 0 0.33", "0.075 0 0", "0 0 0.3", "0.32 0 0.07", "0.08 0 0"};
  const std::array<std::string, 5> axes = {"0 0 1", "0 1 0", "0 1 0", "0 1 0", "1 0 0"};
  std::string text = "<robot name=\"five\"><link name=\"base_link\"/>" +
                     test::fixedJoint("bed", "base_link", "xyz=\"0.45 0 0.02\"");
  std::string parent = "base_link";
  for (std::size_t j = 0; j < origins.size(); ++j) {
    const std::string name = "axis_" + std::to_string(j + 1);
    text += test::rotaryJoint(name, parent, "xyz=\"" + origins[j] + "\"", axes[j]);
    parent = name + "_link";
  }
  std::ostringstream pitch;
  pitch << std::setprecision(17) << M_PI / 2.0 + tilt_rad;
  return text + test::fixedJoint("nozzle", parent, "xyz=\"0.12 0 0.02\" rpy=\"0 " + pitch.str() + " 0\"") +
         "</robot>";
}

/// Distance of two tips [mm].
double tipsApart(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.translation() - b.translation()).norm();
}

double toolAxesApart(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  const Point3 first = a.linear().col(2);
  const Point3 second = b.linear().col(2);
  return std::atan2(first.cross(second).norm(), first.dot(second));
}

/// Of random configurations, how many are among the solutions for the pose, turned about its tool axis.
int foundAmong(const KinematicModel& arm, double turn) {
  Random random(9);
  int found = 0;
  for (int i = 0; i < kRandomPoses;) {
    const JointValues values = test::anyJointValues(arm, random);
    if (arm.singularityMargin(values) < kAwayFromSingular) continue;
    ++i;
    const Eigen::Isometry3d pose = arm.bedFromNozzle(values);
    const Eigen::Isometry3d asked = pose * Eigen::AngleAxisd(turn, Point3::UnitZ());
    bool is_drawn = false;
    for (const InverseSolution& each : arm.solutions(asked, JointValues::Zero(5))) {
      const Eigen::Isometry3d reached = arm.bedFromNozzle(each.values);
      EXPECT_LT(tipsApart(reached, pose), 1e-6);
      EXPECT_LT(toolAxesApart(reached, pose), 1e-9);
      is_drawn |= test::turnDistance(each.values, values) < 1e-6;
    }
    found += is_drawn ? 1 : 0;
  }
  return found;
}

TEST(FiveAxisArm, AToolAxisAsideOfAxisFiveIsReachedWhateverTheTurnAboutIt) {
  const auto arm = kinematicModelFromUrdf(fiveAxisArm(M_PI / 3.0));
  EXPECT_EQ(arm->toolAxisSpin(), ToolAxisSpin::Free);
  EXPECT_FALSE(isSixAxisArm(*arm));
  EXPECT_TRUE(isArm(*arm));
  EXPECT_GE(foundAmong(*arm, 0.7), kRandomPoses * 98 / 100);
}

TEST(FiveAxisArm, WithTheToolAxisAlongAxisFivePosesInItsPlaneAreReached) {
  const auto arm = kinematicModelFromUrdf(fiveAxisArm(0.0));
  EXPECT_EQ(arm->toolAxisSpin(), ToolAxisSpin::Given);
  EXPECT_EQ(foundAmong(*arm, 0.0), kRandomPoses);
  Eigen::Isometry3d down = Eigen::Isometry3d::Identity();
  down.linear() = Eigen::Quaterniond(0, 1, 0, 0).toRotationMatrix();
  down.translation() = Point3(30, 80, 10);
  EXPECT_GE(arm->solutions(down, JointValues::Zero(5)).size(), 2U);
  // Leaning out of the plane through axis 1 and the tip.
  const Point3 radial = Point3(480, 80, 0).normalized();
  const Eigen::Isometry3d leaning = [&] {
    Eigen::Isometry3d pose = down;
    pose.linear() = Eigen::AngleAxisd(0.1, radial) * down.linear();
    return pose;
  }();
  EXPECT_TRUE(arm->solutions(leaning, JointValues::Zero(5)).empty());
}

TEST(FiveAxisArm, IsReportedWithItsClass) {
  EXPECT_EQ(robotReport(fiveAxisArm(0.0)).kinematic_class,
            "five axes, tool axis along axis 5, solved as six with spherical wrist");
  EXPECT_EQ(robotReport(fiveAxisArm(0.0)).joints.size(), 5U);
  EXPECT_EQ(robotReport(fiveAxisArm(M_PI / 3.0)).kinematic_class.find("five axes, tool axis aside of axis 5"),
            0U);
}

/// A bead 60 mm long over the bed, the nozzle down.
Toolpath bead() {
  Path path;
  path.role = PathRole::OuterWall;
  for (int i = 0; i <= 12; ++i) path.points.emplace_back(-30.0 + 5.0 * i, 40.0, 10.0);
  path.orientation = nozzleDown();
  path.feed_mm_s = 20.0;
  path.bead = Bead{0.8, 0.4};
  Toolpath toolpath;
  toolpath.layers.push_back({0.4, 0.4, {path}});
  return toolpath;
}

JointPath plannedWith(const KinematicModel& arm, YawChoice yaw) {
  JointPathSettings settings;
  settings.yaw = yaw;
  NoProgress nobody;
  return planJointPath(bead(), Eigen::Isometry3d::Identity(), arm, settings, nobody);
}

TEST(FiveAxisArm, RunsABeadWithTheNozzleDown) {
  for (const double tilt : {0.0, M_PI / 3.0}) {
    const auto arm = kinematicModelFromUrdf(fiveAxisArm(tilt));
    const JointPath path = plannedWith(*arm, YawChoice::Free);
    ASSERT_TRUE(path.faults.empty()) << path.faults.front().reason;
    for (std::size_t i = 0; i < path.values.size(); ++i) {
      const Eigen::Isometry3d pose = arm->bedFromNozzle(path.values[i]);
      EXPECT_LT((pose.translation() - Point3(-30.0 + 5.0 * static_cast<double>(i), 40.0, 10.0)).norm(), 1e-6);
      EXPECT_NEAR(pose.linear()(2, 2), -1.0, 1e-12);
    }
  }
}

TEST(FiveAxisArm, AHeldTurnAboutItsToolAxisIsRefusedWhereNoJointTurnsIt) {
  const auto aside = kinematicModelFromUrdf(fiveAxisArm(M_PI / 3.0));
  EXPECT_THROW(plannedWith(*aside, YawChoice::Held), InvalidConfig);
  const auto along = kinematicModelFromUrdf(fiveAxisArm(0.0));
  EXPECT_TRUE(plannedWith(*along, YawChoice::Held).faults.empty());
}

}  // namespace
}  // namespace lamina
