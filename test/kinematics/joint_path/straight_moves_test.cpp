// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/joint_path/straight_moves.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "lamina/kinematics/arm/configured_joints.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

/// Joints of an arm at the waypoints of one path over its bed, from those near zero on.
JointPath followed(const Path& path, const KinematicModel& arm) {
  JointPath joints;
  JointValues last = JointValues::Zero(static_cast<Eigen::Index>(arm.joints().size()));
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    Eigen::Isometry3d pose(path.orientation.at(i));
    pose.translation() = path.points[i];
    last = followingJoints(arm, pose, last).value();
    joints.at.push_back({0, 0, i});
    joints.values.push_back(last);
  }
  return joints;
}

Toolpath alone(const Path& path) { return {"path", {{0.2, 0.2, {path}}}}; }

/// A travel in which the nozzle turns by 37 deg where it is, 20 mm over the bed.
Path turnInPlace() {
  Path path = test::straightPath({-12, 6, 20}, {-12, 6, 20});
  path.role = PathRole::Travel;
  path.bead = Bead{};
  path.orientation = AlongPath<Eigen::Quaterniond>(
      {nozzleDown(), Eigen::AngleAxisd(37.0 * M_PI / 180.0, Point3::UnitY()) * nozzleDown()});
  return path;
}

TEST(StraightMoves, ATurnInPlaceKeepsTheTipWhereItIs) {
  const auto arm = kinematicModelByName("irb_4600");
  const Path path = turnInPlace();
  const JointPath stated = followed(path, *arm);
  // Half way of all six joints the tip is somewhere else.
  const JointValues half = 0.5 * (stated.values[0] + stated.values[1]);
  EXPECT_GT((arm->bedFromNozzle(half).translation() - path.points[0]).norm(), 5.0);
  const JointPathSettings settings;
  const DividedJointPath led = alongStraightMoves(alone(path), stated, *arm, settings);
  ASSERT_GT(led.joints.at.size(), 7U) << "steps of at most 5 deg";
  ASSERT_EQ(led.joints.values.size(), led.joints.at.size());
  EXPECT_TRUE(led.joints.isRunnable());
  for (std::size_t i = 1; i < led.joints.at.size(); ++i) {
    EXPECT_EQ(led.divided.originalOf(led.joints.at[i]), (WaypointIndex{0, 0, 1}));
    const JointValues between = 0.5 * (led.joints.values[i - 1] + led.joints.values[i]);
    EXPECT_LE((arm->bedFromNozzle(between).translation() - path.points[0]).norm(),
              settings.division.tip_tolerance_mm);
  }
  EXPECT_EQ(led.joints.values.front(), stated.values.front());
  EXPECT_EQ(led.joints.values.back(), stated.values.back());
}

TEST(StraightMoves, FaultsStayAtTheirWaypointsAndNothingIsLedToOneWithoutJoints) {
  const auto arm = kinematicModelByName("irb_4600");
  Path path = test::straightPath({0, 0, 0.2}, {20, 0, 0.2});
  path.points.push_back({40, 0, 0.2});
  path.points.push_back({60, 0, 0.2});
  path.orientation = AlongPath<Eigen::Quaterniond>(nozzleDown());
  JointPath stated = followed(path, *arm);
  stated.values[2] = JointValues();
  stated.faults.push_back({{0, 0, 2}, JointFault::Configuration, "no such joints"});
  const DividedJointPath led = alongStraightMoves(alone(path), stated, *arm, {});
  // 20 mm in steps of 5 mm, and two motions that stay whole.
  ASSERT_EQ(led.joints.at.size(), 7U);
  EXPECT_EQ(led.joints.values[5].size(), 0);
  ASSERT_EQ(led.joints.faults.size(), 1U);
  EXPECT_EQ(led.joints.faults[0].at, (WaypointIndex{0, 0, 5}));
  EXPECT_EQ(led.divided.originalOf(led.joints.faults[0].at), (WaypointIndex{0, 0, 2}));
}

TEST(StraightMoves, AClosedPathIsLedBackToWhereItBegan) {
  const auto arm = kinematicModelByName("irb_4600");
  Path path = test::straightPath({0, 0, 0.2}, {10, 0, 0.2});
  path.points.push_back({10, 10, 0.2});
  path.points.push_back({0, 10, 0.2});
  path.is_closed = true;
  path.orientation = AlongPath<Eigen::Quaterniond>(nozzleDown());
  JointPath stated = followed(path, *arm);
  stated.at.push_back({0, 0, 0});
  stated.values.push_back(stated.values.front());
  const DividedJointPath led = alongStraightMoves(alone(path), stated, *arm, {});
  ASSERT_EQ(led.joints.at.size(), 9U);
  EXPECT_EQ(led.joints.at.back(), (WaypointIndex{0, 0, 0}));
  const Point3 last_middle = arm->bedFromNozzle(led.joints.values[7]).translation();
  EXPECT_LT((last_middle - Point3(0, 5, 0.2)).norm(), 1e-6);
}

}  // namespace
}  // namespace lamina
