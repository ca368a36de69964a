// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "kinematics/joint_path/arm_rail.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"
#include "support/arms.hpp"

namespace lamina {
namespace {

constexpr double kFeed = 50.0;          // mm/s
constexpr double kPlate = 4000.0;       // mm, from x = 1000
constexpr double kArm = 950.0 + 950.0;  // mm
constexpr Eigen::Index kRail = 6;       // among the joints
const Eigen::Isometry3d kPlace = Eigen::Isometry3d(Eigen::Translation3d(1000.0, 0.0, 0.0));

Path straight(const Point3& from, const Point3& to, PathRole role) {
  constexpr int kSteps = 40;
  Path path;
  path.role = role;
  path.feed_mm_s = kFeed;
  if (role != PathRole::Travel) path.bead = Bead{6.0, 2.0};
  path.points.reserve(kSteps + 1);
  for (int i = 0; i <= kSteps; ++i)
    path.points.emplace_back(from + (to - from) * (static_cast<double>(i) / kSteps));
  path.orientation = Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0);
  return path;
}

/// One bead along the whole plate.
Toolpath alongPlate() {
  return {"along", {{2.0, 2.0, {straight({0, 0, 2}, {kPlate, 0, 2}, PathRole::OuterWall)}}}};
}

/// Beads of 400 mm across the plate, 100 mm apart.
Toolpath acrossPlate() {
  ToolpathLayer layer{2.0, 2.0, {}};
  for (double x = 0.0; x <= kPlate; x += 100.0) {
    if (x > 0.0) layer.paths.push_back(straight({x - 100.0, 400, 2}, {x, 0, 2}, PathRole::Travel));
    layer.paths.push_back(straight({x, 0, 2}, {x, 400, 2}, PathRole::Infill));
  }
  return {"across", {layer}};
}

JointPath plannedOnRail(const Toolpath& toolpath, RailChoice rail, const std::string& rail_end_m = "6") {
  const auto model = kinematicModelFromUrdf(test::railArm(rail_end_m));
  JointPathSettings settings;
  settings.rail = rail;
  settings.yaw_samples = 24;
  NoProgress nobody;
  return planJointPath(toolpath, kPlace, *model, settings, nobody);
}

/// Distance of the wrist from the shoulder, were axis 1 turned to the wrist, as the links stand.
double stretch(const KinematicModel& model, const JointValues& values) {
  const auto links = model.bedFromLinks(values);
  const Point3 wrist = links.at("base_link").inverse() * links.at("joint_5_link").translation();
  return std::hypot(wrist.head<2>().norm() - 150.0, wrist.z() - 500.0);
}

void expectWithinReach(const JointPath& path) {
  const auto model = kinematicModelFromUrdf(test::railArm());
  ASSERT_TRUE(path.isRunnable()) << path.faults.front().reason;
  for (const JointValues& values : path.values) {
    ASSERT_EQ(values.size(), 7);
    EXPECT_GE(stretch(*model, values), 0.34 * kArm);
    EXPECT_LE(stretch(*model, values), 0.91 * kArm);
  }
}

std::string refusalOnRail(const Toolpath& toolpath, RailChoice rail, const std::string& rail_end_m) {
  try {
    plannedOnRail(toolpath, rail, rail_end_m);
    return "";
  } catch (const Unreachable& error) {
    return error.what();
  }
}

TEST(RailValues, AHeldRailLeavesMostOfAPlateOutOfReach) {
  const JointPath path = plannedOnRail(alongPlate(), RailChoice::Held);
  EXPECT_FALSE(path.isRunnable());
  for (const JointValues& values : path.values)
    if (values.size() > 0) {
      EXPECT_EQ(values[kRail], 0.0);
    }
}

TEST(RailValues, ARailThatFollowsReachesAPlateOf4MetresAtOneSpeed) {
  const JointPath path = plannedOnRail(alongPlate(), RailChoice::Follow);
  expectWithinReach(path);
  // The plate is 700 mm aside, the wrist 302 - 500 mm over the shoulder: 0.7 of the reach at the start, 0.9
  // at the end, by Pythagoras.
  const auto behind = [](double share) {
    const double level = 150.0 + std::sqrt(std::pow(share * kArm, 2) - 198.0 * 198.0);
    return std::sqrt(level * level - 700.0 * 700.0);
  };
  EXPECT_NEAR(path.values.front()[kRail], 1000.0 - std::min(1000.0, behind(0.7)), 1e-6);
  EXPECT_NEAR(path.values.back()[kRail], 5000.0 - behind(0.9), 1e-6);
  const double step = (path.values.back()[kRail] - path.values.front()[kRail]) / 40.0;
  EXPECT_LT(step / (kPlate / 40.0 / kFeed), kFeed);
  for (std::size_t i = 1; i < path.values.size(); ++i)
    EXPECT_NEAR(path.values[i][kRail] - path.values[i - 1][kRail], step, 1e-6);
}

TEST(RailValues, ARailThatStepsMovesOnTravelsOnly) {
  const Toolpath toolpath = acrossPlate();
  const JointPath path = plannedOnRail(toolpath, RailChoice::Steps);
  expectWithinReach(path);
  std::set<double> stands;
  for (std::size_t i = 1; i < path.at.size(); ++i) {
    const WaypointIndex& at = path.at[i];
    const double step_mm = std::abs(path.values[i][kRail] - path.values[i - 1][kRail]);
    const Path& run = toolpath.layers[at.layer].paths[at.path];
    if (at.waypoint > 0) {
      const double way_mm = (run.points[at.waypoint] - run.points[at.waypoint - 1]).norm();
      EXPECT_LE(step_mm, 1500.0 * way_mm / kFeed);
    }
    if (run.role == PathRole::Travel) continue;
    EXPECT_EQ(step_mm, 0.0) << at.path;
    stands.insert(path.values[i][kRail]);
  }
  // Of a plate 700 to 1100 mm aside the arm reaches 1134 mm from one place, twelve beads: 41 take four.
  EXPECT_EQ(stands.size(), 4U);
}

TEST(RailValues, ABeadThatNeedsTheRailToMoveIsRefusedInSteps) {
  const std::string refusal = refusalOnRail(alongPlate(), RailChoice::Steps, "6");
  EXPECT_NE(refusal.find("'external_1' would have to move along the bead"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("joints.rail follow"), std::string::npos) << refusal;
}

TEST(RailValues, ARailThatIsTooShortIsRefusedByName) {
  for (const RailChoice rail : {RailChoice::Follow, RailChoice::Steps}) {
    const std::string refusal = refusalOnRail(acrossPlate(), rail, "1.5");
    EXPECT_NE(refusal.find("joint 'external_1' would have to stand at"), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("0 mm to 1500 mm"), std::string::npos) << refusal;
  }
}

/// Straight across a plate of 4 m x 3 m: the bridge has to follow, and the trolley keeps the wrist within 0.3
/// of the reach of 1900 mm aside of the arm.
TEST(RailValues, AGantryFollowsOnBothAxes) {
  const auto model = kinematicModelFromUrdf(test::gantryArm());
  const Toolpath toolpath = {"askew",
                             {{2.0, 2.0, {straight({0, 0, 2}, {kPlate, 3000, 2}, PathRole::OuterWall)}}}};
  JointPathSettings settings;
  settings.rail = RailChoice::Follow;
  settings.yaw_samples = 24;
  NoProgress nobody;
  const JointPath path = planJointPath(toolpath, kPlace, *model, settings, nobody);
  ASSERT_TRUE(path.isRunnable()) << path.faults.front().reason;
  for (const JointValues& values : path.values) {
    ASSERT_EQ(values.size(), 8);
    EXPECT_GE(stretch(*model, values), 0.34 * kArm);
    EXPECT_LE(stretch(*model, values), 0.91 * kArm);
    const auto links = model->bedFromLinks(values);
    const Point3 wrist = links.at("base_link").inverse() * links.at("joint_5_link").translation();
    EXPECT_LE(std::abs(wrist.y()), 0.3 * kArm + 1.0);
  }
  // From where the trolley is level with the wrist, at 700 mm, to 570 mm short of 3700 mm.
  EXPECT_NEAR(path.values.front()[kRail + 1], 700.0, 1e-6);
  EXPECT_NEAR(path.values.back()[kRail + 1], 3130.0, 1e-6);
  EXPECT_GT(path.values.back()[kRail] - path.values.front()[kRail], 1500.0);
  EXPECT_THROW(
      {
        settings.rail = RailChoice::Steps;
        planJointPath(toolpath, kPlace, *model, settings, nobody);
      },
      InvalidConfig);
}

TEST(RailValues, AGantryWhoseAxesRunAlikeIsRefusedByName) {
  for (const auto& [trolley, what] :
       {std::pair("0.96 0.28 0", "joints 'external_1' and 'external_2' carry it the same way"),
        std::pair("0 0.8 0.6", "joint 'external_2' runs 36.87 deg off a right angle to axis 1")}) {
    try {
      armRail(*kinematicModelFromUrdf(test::gantryArm(trolley)));
      ADD_FAILURE() << trolley;
    } catch (const InvalidConfig& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  }
  // One along axis 1 lifts the arm, and is held.
  EXPECT_TRUE(armRail(*kinematicModelFromUrdf(test::gantryArm("0 0 1"))).across.empty());
}

TEST(RailValues, ArmsWithoutARailAreRefusedByName) {
  try {
    armRail(*kinematicModelByName("irb_4600_turntable"));
    FAIL();
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("has 0 linear external axes"), std::string::npos);
  }
}

}  // namespace
}  // namespace lamina
