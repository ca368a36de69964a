// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Joint paths of arms of seven axes: the arm angle is chosen along the toolpath.
#include "kinematics/joint_path/redundancy_ladder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/parallel.hpp"
#include "lamina/kinematics/joint_path/divided_joint_path.hpp"
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"
#include "lamina/kinematics/joint_path/straight_moves.hpp"
#include "support/arms.hpp"

namespace lamina {
namespace {

constexpr double kTurnLimit = 10.0 * M_PI / 180.0;  // of a joint from a waypoint to the next, 5 mm on

Path beadThrough(std::vector<Point3> points) {
  Path path;
  path.role = PathRole::OuterWall;
  path.orientation = nozzleDown();
  path.feed_mm_s = 20.0;
  path.bead = Bead{0.8, 0.4};
  path.points = std::move(points);
  return path;
}

Path travelBetween(const Point3& from, const Point3& to) {
  Path path = beadThrough({from, from + Point3(0, 0, 5), to + Point3(0, 0, 5), to});
  path.role = PathRole::Travel;
  path.feed_mm_s = 100.0;
  return path;
}

Toolpath ring(const Point3& centre, double radius_mm) {
  std::vector<Point3> points;
  for (int i = 0; i <= 72; ++i) {
    const double at = i * M_PI / 36.0;
    points.push_back(centre + radius_mm * Point3(std::cos(at), std::sin(at), 0.0));
  }
  Toolpath toolpath;
  toolpath.layers.push_back({0.4, 0.4, {beadThrough(points)}});
  return toolpath;
}

/// Lines along y, 20 mm apart, with a lifted travel to each.
Toolpath raster(const Point3& corner, int lines, double length_mm) {
  Toolpath toolpath;
  toolpath.layers.push_back({0.4, 0.4, {}});
  auto& paths = toolpath.layers.front().paths;
  for (int i = 0; i < lines; ++i) {
    const Point3 from = corner + Point3(20.0 * i, 0.0, 0.0);
    const Point3 to = from + Point3(0.0, length_mm, 0.0);
    if (i > 0) paths.push_back(travelBetween(paths.back().points.back(), from));
    paths.push_back(beadThrough({from, to}));
  }
  return toolpath;
}

DividedJointPath planned(const KinematicModel& arm, const Toolpath& toolpath, int samples) {
  JointPathSettings settings;
  settings.yaw_samples = 36;
  settings.redundancy_samples = samples;
  NoProgress nobody;
  return planDividedJointPath(toolpath, Eigen::Isometry3d::Identity(), arm, settings, nobody);
}

/// The tip on the toolpath, the tool axis down, joints within their limits, and steady along beads.
void expectRuns(const DividedJointPath& run, const KinematicModel& arm) {
  ASSERT_TRUE(run.joints.faults.empty()) << run.joints.faults.front().reason;
  EXPECT_LE(run.greatest.tip_mm, 0.02);
  for (std::size_t i = 0; i < run.joints.at.size(); ++i) {
    const WaypointIndex& at = run.joints.at[i];
    const Path& path = run.divided.toolpath.layers[at.layer].paths[at.path];
    const JointValues& values = run.joints.values[i];
    const Eigen::Isometry3d pose = arm.bedFromNozzle(values);
    ASSERT_LT((pose.translation() - path.points[at.waypoint]).norm(), 1e-6);
    ASSERT_LT(std::acos(std::min(1.0, -pose.linear()(2, 2))), 1e-7);
    for (Eigen::Index j = 0; j < values.size(); ++j) {
      const DrivenJoint& joint = arm.joints()[static_cast<std::size_t>(j)];
      ASSERT_GE(values[j], joint.low - 1e-9) << joint.name;
      ASSERT_LE(values[j], joint.high + 1e-9) << joint.name;
    }
    if (i == 0 || path.role == PathRole::Travel || run.joints.at[i - 1].path != at.path) continue;
    ASSERT_LT((values - run.joints.values[i - 1]).cwiseAbs().maxCoeff(), kTurnLimit) << "waypoint " << i;
  }
}

double greatestAngle(const DividedJointPath& run, const KinematicModel& arm) {
  double greatest = 0.0;
  for (const JointValues& values : run.joints.values)
    greatest = std::max(greatest, std::abs(arm.redundancy()->angleAt(values)));
  return greatest;
}

TEST(RedundancyLadder, ARingAndARasterAreRunSteadily) {
  for (const auto& description : {test::sphericalSeven(), test::nearlySphericalSeven()}) {
    const auto arm = kinematicModelFromUrdf(description.urdf());
    expectRuns(planned(*arm, ring({0, 0, 20}, 60.0), 18), *arm);
    expectRuns(planned(*arm, raster({-60, -60, 20}, 5, 120.0), 18), *arm);
  }
}

TEST(RedundancyLadder, AnArmWhoseAxesDoNotMeetRunsToo) {
  const auto arm = kinematicModelFromUrdf(test::offsetSeven().urdf());
  expectRuns(planned(*arm, raster({-20, -20, 20}, 2, 40.0), 6), *arm);
}

/// An arm whose first axis hardly turns cannot reach aside with its elbow in the plane of axis 1.
TEST(RedundancyLadder, TheElbowTurnsAsideWhereHoldingItViolatesALimit) {
  test::SevenAxisDescription description = test::sphericalSeven();
  description.limits_deg[0] = 10.0;
  const auto arm = kinematicModelFromUrdf(description.urdf());
  // Seen from axis 1, 24 to 37 deg aside.
  const Toolpath aside = ring({-50, 250, 20}, 40.0);
  const DividedJointPath held = planned(*arm, aside, 1);
  ASSERT_FALSE(held.joints.faults.empty());
  EXPECT_EQ(held.joints.faults.front().fault, JointFault::OutOfLimits);
  EXPECT_NE(held.joints.faults.front().reason.find("axis_1"), std::string::npos);
  const DividedJointPath resolved = planned(*arm, aside, 18);
  expectRuns(resolved, *arm);
  EXPECT_GT(greatestAngle(resolved, *arm), 0.3);
}

TEST(RedundancyLadder, OneSampleHoldsTheArmAngleAtZero) {
  const auto arm = kinematicModelFromUrdf(test::sphericalSeven().urdf());
  const DividedJointPath held = planned(*arm, ring({0, 0, 20}, 30.0), 1);
  expectRuns(held, *arm);
  for (const JointValues& values : held.joints.values)
    EXPECT_NEAR(arm->redundancy()->angleAt(values), 0.0, 1e-9);
}

TEST(RedundancyLadder, OnAStraightMotionTheArmAngleGoesSteadilyFromEndToEnd) {
  const auto arm = kinematicModelFromUrdf(test::sphericalSeven().urdf());
  const Path bead = beadThrough({{-30, 0, 20}, {30, 0, 20}});
  JointPath stated;
  for (std::size_t i = 0; i < 2; ++i) {
    Eigen::Isometry3d pose(bead.orientation.at(i));
    pose.translation() = bead.points[i];
    const double angle = i == 0 ? 0.1 : 0.5;
    const JointValues zero = JointValues::Zero(7);
    stated.at.push_back({0, 0, i});
    stated.values.push_back(arm->redundancy()->solutionsWith(pose, zero, angle)[2].values);
  }
  Toolpath toolpath;
  toolpath.layers.push_back({0.4, 0.4, {bead}});
  const DividedJointPath led = alongStraightMoves(toolpath, stated, *arm, {});
  ASSERT_TRUE(led.joints.faults.empty());
  ASSERT_GE(led.joints.values.size(), 13U);
  for (std::size_t i = 0; i < led.joints.values.size(); ++i) {
    const Eigen::Isometry3d pose = arm->bedFromNozzle(led.joints.values[i]);
    const double part = (pose.translation().x() + 30.0) / 60.0;
    EXPECT_NEAR(arm->redundancy()->angleAt(led.joints.values[i]), 0.1 + 0.4 * part, 1e-6);
  }
}

TEST(RedundancyLadder, TheResultDoesNotDependOnTheNumberOfThreads) {
  const auto arm = kinematicModelFromUrdf(test::sphericalSeven().urdf());
  const DividedJointPath many = planned(*arm, ring({0, 0, 20}, 60.0), 12);
  const ThreadLimit limit(1);
  const DividedJointPath one = planned(*arm, ring({0, 0, 20}, 60.0), 12);
  ASSERT_EQ(one.joints.values.size(), many.joints.values.size());
  for (std::size_t i = 0; i < one.joints.values.size(); ++i)
    EXPECT_EQ(one.joints.values[i], many.joints.values[i]);
}

TEST(RedundancyLadder, LeavesStationsOfOtherModelsAsTheyAre) {
  const auto arm = kinematicModelFromUrdf(test::exactParallelAxesArm().urdf());
  std::vector<Station> stations(3);
  const NoGuard nobody;
  NoProgress silent;
  resolveRedundancy(stations, {*arm, nobody}, {}, silent);
  for (const Station& station : stations) EXPECT_EQ(station.redundancy, 0.0);
}

}  // namespace
}  // namespace lamina
