// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "support/gantry_head.hpp"

namespace lamina {
namespace {

using test::GantryHead;

constexpr double kDegree = M_PI / 180.0;

/// Nozzle whose tool axis is inclined from straight down towards an azimuth.
Eigen::Quaterniond inclined(double azimuth_deg, double tilt_deg) {
  const Eigen::AngleAxisd tilt(
      -tilt_deg * kDegree,
      Eigen::AngleAxisd((azimuth_deg + 90.0) * kDegree, Point3::UnitZ()) * Point3::UnitX());
  return tilt * nozzleDown();
}

Path pathThrough(PathRole role, std::vector<Point3> points, std::vector<Eigen::Quaterniond> nozzles) {
  Path path;
  path.role = role;
  path.points = std::move(points);
  path.orientation = AlongPath<Eigen::Quaterniond>(std::move(nozzles));
  path.feed_mm_s = role == PathRole::Travel ? 100.0 : 20.0;
  if (role != PathRole::Travel) path.bead = Bead{0.5, 0.2};
  return path;
}

Toolpath toolpathOf(std::vector<Path> paths) {
  Toolpath toolpath;
  toolpath.layers.push_back({0.2, 0.2, std::move(paths)});
  return toolpath;
}

/// A circle in steps of 5 deg, with the tool axis inclined outwards by 30 deg.
Path circle(double z_mm, double turn_deg = 360.0) {
  std::vector<Point3> points;
  std::vector<Eigen::Quaterniond> nozzles;
  for (double at = 0.0; at <= turn_deg + 1e-9; at += 5.0) {
    points.emplace_back(20.0 * std::cos(at * kDegree), 20.0 * std::sin(at * kDegree), z_mm);
    nozzles.push_back(inclined(at, 30.0));
  }
  return pathThrough(PathRole::OuterWall, points, nozzles);
}

/// Circles above each other, each with a travel up to the next.
Toolpath tower(int circles) {
  std::vector<Path> paths;
  for (int i = 0; i < circles; ++i) {
    paths.push_back(circle(i));
    if (i + 1 == circles) break;
    const Point3 end(20.0, 0.0, i);
    paths.push_back(pathThrough(PathRole::Travel,
                                {end, end + Point3(5, 0, 5), end + Point3(5, 9, 5), end + Point3(0, 0, 1)},
                                std::vector<Eigen::Quaterniond>(4, inclined(0.0, 30.0))));
  }
  return toolpathOf(std::move(paths));
}

JointPath plan(const Toolpath& toolpath, const KinematicModel& model,
               const JointPathSettings& settings = {}) {
  NoProgress progress;
  return planJointPath(toolpath, Eigen::Isometry3d::Identity(), model, settings, progress);
}

/// Angle of the tool axis, and distance of the tip, to what the toolpath asks: the greatest of all waypoints.
struct Misses {
  double tip_mm = 0.0;
  double tool_axis = 0.0;
};

Misses misses(const JointPath& path, const Toolpath& toolpath, const KinematicModel& model) {
  Misses most;
  for (std::size_t i = 0; i < path.at.size(); ++i) {
    const Path& asked = toolpath.layers[path.at[i].layer].paths[path.at[i].path];
    const Eigen::Isometry3d is = model.bedFromNozzle(path.values[i]);
    const Point3 tool_axis = asked.orientation.at(path.at[i].waypoint) * Point3::UnitZ();
    const Point3 own = is.linear().col(2);
    most.tip_mm = std::max(most.tip_mm, (is.translation() - asked.points[path.at[i].waypoint]).norm());
    most.tool_axis = std::max(most.tool_axis, std::atan2(own.cross(tool_axis).norm(), own.dot(tool_axis)));
  }
  return most;
}

/// The greatest step of a joint on depositing motions [rad].
double greatestStep(const JointPath& path, const Toolpath& toolpath, Eigen::Index joint) {
  double greatest = 0.0;
  for (std::size_t i = 1; i < path.at.size(); ++i)
    if (toolpath.layers[path.at[i].layer].paths[path.at[i].path].role != PathRole::Travel)
      greatest = std::max(greatest, std::abs(path.values[i][joint] - path.values[i - 1][joint]));
  return greatest;
}

TEST(JointPathPlanner, BringsTheNozzleToEveryWaypoint) {
  const GantryHead machine(ToolAxisSpin::Free, 400.0, 60.0);
  const Toolpath toolpath = tower(2);
  const JointPath path = plan(toolpath, machine);
  ASSERT_TRUE(path.isRunnable());
  ASSERT_EQ(path.at.size(), path.values.size());
  EXPECT_EQ(path.at.size(), 73U + 4U + 73U);
  const Misses most = misses(path, toolpath, machine);
  EXPECT_LT(most.tip_mm, 1e-9);
  EXPECT_LT(most.tool_axis, 1e-9);
}

// A circle turns c by 360 deg. Its start is at -90 or 270 deg in one branch, at 90 or -270 in the other.
TEST(JointPathPlanner, RewindsATurningHeadOnTravelsAsOftenAsItsLimitsAsk) {
  EXPECT_EQ(plan(tower(6), GantryHead(ToolAxisSpin::Free, 280.0)).rewinds, 5U);  // -90 to 270
  EXPECT_EQ(plan(tower(6), GantryHead(ToolAxisSpin::Free, 640.0)).rewinds, 1U);  // -450 to 630
  EXPECT_EQ(plan(tower(6), GantryHead(ToolAxisSpin::Free, 1200.0)).rewinds, 0U);
}

TEST(JointPathPlanner, RewindsOnTheHighestMotionOfATravel) {
  const Toolpath toolpath = tower(2);
  const JointPath path = plan(toolpath, GantryHead(ToolAxisSpin::Free, 280.0));
  ASSERT_EQ(path.rewinds, 1U);
  for (std::size_t i = 1; i < path.at.size(); ++i) {
    const bool is_rewind = std::abs(path.values[i][3] - path.values[i - 1][3]) > M_PI;
    EXPECT_EQ(is_rewind, path.at[i].path == 1 && path.at[i].waypoint == 2) << i;
  }
}

TEST(JointPathPlanner, NeverRewindsASpiralOnAHeadThatTurnsForEver) {
  const Toolpath toolpath = toolpathOf({circle(0.0, 20 * 360.0)});
  const JointPath path = plan(toolpath, GantryHead(ToolAxisSpin::Free, 1e6));
  EXPECT_TRUE(path.isRunnable());
  EXPECT_EQ(path.rewinds, 0U);
  EXPECT_NEAR(std::abs(path.values.back()[3] - path.values.front()[3]), 20 * 2.0 * M_PI, 1e-6);
}

TEST(JointPathPlanner, NamesWhereARunWindsUpAHead) {
  // c starts at -90 deg, or at 270 and thus -90; it reaches 280 after 370 deg, which is waypoint 74.
  const JointPath path = plan(toolpathOf({circle(0.0, 600.0)}), GantryHead(ToolAxisSpin::Free, 281.0));
  ASSERT_EQ(path.faults.size(), 1U);
  EXPECT_EQ(path.faults[0].fault, JointFault::JointUnwinding);
  EXPECT_NE(path.faults[0].reason.find("joint c"), std::string::npos) << path.faults[0].reason;
  EXPECT_NE(path.faults[0].reason.find("it turns by 600 deg there, of 562 deg"), std::string::npos)
      << path.faults[0].reason;
}

TEST(JointPathPlanner, SaysFromWhereARunWouldNotWindUpAHead) {
  // c goes from -90 to 410 deg, or back to -590; within 281 to either side it would go from -281 or -219.
  const JointPath path = plan(toolpathOf({circle(0.0, 500.0)}), GantryHead(ToolAxisSpin::Free, 281.0));
  ASSERT_EQ(path.faults.size(), 1U);
  EXPECT_NE(path.faults[0].reason.find("it turns by 500 deg there, of 562 deg, and fits if it begins 129 deg "
                                       "to 191 deg lower"),
            std::string::npos)
      << path.faults[0].reason;
}

/// An arc of 20 deg about an azimuth.
Path arcAbout(double azimuth_deg) {
  std::vector<Point3> points;
  std::vector<Eigen::Quaterniond> nozzles;
  for (double at = azimuth_deg - 10.0; at <= azimuth_deg + 10.0; at += 5.0) {
    points.emplace_back(20.0 * std::cos(at * kDegree), 20.0 * std::sin(at * kDegree), 0.0);
    nozzles.push_back(inclined(at, 30.0));
  }
  return pathThrough(PathRole::OuterWall, points, nozzles);
}

// About 90 deg c goes through 0 in one branch and through 180 deg in the other, about 270 deg the other way
// round; both cost the same.
TEST(JointPathPlanner, KeepsToTheBranchThatWindsNothingUp) {
  const GantryHead machine(ToolAxisSpin::Free, 180.0);
  for (const double azimuth_deg : {90.0, 270.0}) {
    const Toolpath toolpath = toolpathOf({arcAbout(azimuth_deg)});
    const JointPath path = plan(toolpath, machine);
    ASSERT_TRUE(path.isRunnable()) << azimuth_deg << ": " << path.faults[0].reason;
    EXPECT_NEAR(greatestStep(path, toolpath, 3), 5.0 * kDegree, 1e-9) << azimuth_deg;
    EXPECT_NEAR(path.values[2][3], 0.0, 1e-9) << azimuth_deg;
    EXPECT_LT(misses(path, toolpath, machine).tool_axis, 1e-9) << azimuth_deg;
  }
}

TEST(JointPathPlanner, GoesStraightThroughTheSingularityOfAHead) {
  // The tool axis goes from 20 deg on one side through straight down to 20 deg on the other: a alone has to
  // turn.
  std::vector<Point3> points;
  std::vector<Eigen::Quaterniond> nozzles;
  for (int i = -10; i <= 10; ++i) {
    points.emplace_back(i, 0, 0);
    nozzles.push_back(inclined(0.0, 2.0 * i));
  }
  const Toolpath toolpath = toolpathOf({pathThrough(PathRole::Infill, points, nozzles)});
  const GantryHead machine(ToolAxisSpin::Free);
  const JointPath path = plan(toolpath, machine);
  ASSERT_TRUE(path.isRunnable()) << path.faults[0].reason;
  EXPECT_LT(greatestStep(path, toolpath, 3), 1e-6);
  EXPECT_LT(misses(path, toolpath, machine).tool_axis, 1e-7);
}

TEST(JointPathPlanner, TurnsAHeadWhileItsToolAxisIsStraightDown) {
  // Between a tool axis inclined towards 0 deg and one towards 90 deg it is straight down for 20 mm.
  std::vector<Point3> points;
  std::vector<Eigen::Quaterniond> nozzles;
  for (int i = 0; i <= 40; ++i) {
    points.emplace_back(i, 0, 0);
    nozzles.push_back(i < 10 ? inclined(0.0, 10.0 - i) : i < 30 ? nozzleDown() : inclined(90.0, i - 30.0));
  }
  const Toolpath toolpath = toolpathOf({pathThrough(PathRole::Infill, points, nozzles)});
  const JointPath path = plan(toolpath, GantryHead(ToolAxisSpin::Free));
  ASSERT_TRUE(path.isRunnable()) << path.faults[0].reason;
  EXPECT_LT(greatestStep(path, toolpath, 3), 11.0 * kDegree);
}

TEST(JointPathPlanner, NamesASwingBesideASingularity) {
  // The tool axis passes straight down at 0.2 deg: c swings by nearly half a turn within a few waypoints.
  std::vector<Point3> points;
  std::vector<Eigen::Quaterniond> nozzles;
  for (int i = -40; i <= 40; ++i) {
    points.emplace_back(0.1 * i, 0, 0);
    nozzles.push_back(inclined(90.0, 0.2) * nozzleDown().inverse() * inclined(0.0, 0.1 * i));
  }
  const Toolpath toolpath = toolpathOf({pathThrough(PathRole::Infill, points, nozzles)});
  const GantryHead machine(ToolAxisSpin::Free, 280.0);
  JointPathSettings settings;
  settings.max_slowdown = 10.0;
  const JointPath swinging = plan(toolpath, machine, settings);
  ASSERT_FALSE(swinging.isRunnable());
  for (const FaultyWaypoint& faulty : swinging.faults) EXPECT_EQ(faulty.fault, JointFault::Singular);
  settings.singular_tool_axis_tolerance_deg = 0.5;
  const JointPath passing = plan(toolpath, machine, settings);
  ASSERT_TRUE(passing.isRunnable()) << passing.faults[0].reason;
  EXPECT_LE(misses(passing, toolpath, machine).tool_axis, 0.5 * kDegree);
}

TEST(JointPathPlanner, TurnsANozzleThatMayTurnInsteadOfWindingItsHead) {
  // Held, the spin follows the toolpath's; free, it need not, and nothing but c and a moves.
  const GantryHead machine(ToolAxisSpin::Given, 1000.0);
  const Toolpath toolpath = toolpathOf({circle(0.0)});
  const JointPath path = plan(toolpath, machine);
  ASSERT_TRUE(path.isRunnable());
  EXPECT_LT(misses(path, toolpath, machine).tool_axis, 1e-9);
  EXPECT_LT(greatestStep(path, toolpath, 5), 0.1);
}

TEST(JointPathPlanner, ChangesTheBranchOfAHeadOnATravelThatItsLimitsAskItTo) {
  // c goes from 80 to 130 deg in one branch and from -100 to -50 in the other; its limits let neither run be
  // made in the branch of the other run.
  GantryHead machine(ToolAxisSpin::Free);
  machine.changedJoints()[3].low = -110.0 * kDegree;
  machine.changedJoints()[3].high = 110.0 * kDegree;
  const auto run = [](double from_deg, double y) {
    std::vector<Point3> points;
    std::vector<Eigen::Quaterniond> nozzles;
    for (int i = 0; i <= 10; ++i) {
      points.emplace_back(i, y, 0);
      nozzles.push_back(inclined(from_deg - 90.0 + 5.0 * i, 30.0));
    }
    return pathThrough(PathRole::Infill, points, nozzles);
  };
  const Path first = run(50.0, 0.0);
  const Path second = run(80.0, 10.0);
  const Path third = run(-120.0, 20.0);
  const auto travel = [](const Path& from, const Path& to) {
    return pathThrough(PathRole::Travel, {from.lastPoint(), to.firstPoint()},
                       {from.orientation.at(10), to.orientation.at(0)});
  };
  const Toolpath toolpath = toolpathOf({first, travel(first, second), second, travel(second, third), third});
  const JointPath path = plan(toolpath, machine);
  ASSERT_TRUE(path.isRunnable()) << path.faults[0].reason;
  EXPECT_LT(misses(path, toolpath, machine).tool_axis, 1e-9);
  JointPathSettings settings;
  settings.branch_change = BranchChange::Never;
  EXPECT_FALSE(plan(toolpath, machine, settings).isRunnable());
}

TEST(JointPathPlanner, NamesEveryWaypointOutOfReach) {
  const auto arm = kinematicModelByName("irb_4600");
  std::vector<Point3> points;
  for (int i = 0; i <= 10; ++i) points.emplace_back(1000.0 * i, 0, 100);
  const Toolpath toolpath =
      toolpathOf({pathThrough(PathRole::Travel, points, std::vector<Eigen::Quaterniond>(11, nozzleDown()))});
  const JointPath path = plan(toolpath, *arm);
  // The arm reaches 2.05 m from its first axis, whichever way it stands.
  ASSERT_GE(path.faults.size(), 6U);
  EXPECT_EQ(path.faults.back().fault, JointFault::OutOfReach);
  EXPECT_EQ(path.faults.back().at.waypoint, 10U);
}

TEST(JointPathPlanner, LeadsAnArmAlongSteepWalls) {
  const auto arm = kinematicModelByName("irb_4600");
  const Toolpath toolpath = tower(2);
  const JointPath path = plan(toolpath, *arm);
  ASSERT_TRUE(path.isRunnable()) << path.faults[0].reason;
  const Misses most = misses(path, toolpath, *arm);
  EXPECT_LT(most.tip_mm, 1e-6);
  EXPECT_LT(most.tool_axis, 1e-9);
  for (Eigen::Index joint = 0; joint < 6; ++joint)
    EXPECT_LT(greatestStep(path, toolpath, joint), 15.0 * kDegree);
}

TEST(JointPathPlanner, NamesEveryWaypointThatIsOutOfLimits) {
  GantryHead machine(ToolAxisSpin::Free);
  machine.changedJoints()[0].high = 10.5;
  std::vector<Point3> points;
  for (int i = 0; i <= 20; ++i) points.emplace_back(i < 15 ? i : 20 - i, i, 0);
  const Toolpath toolpath =
      toolpathOf({pathThrough(PathRole::Infill, points, std::vector<Eigen::Quaterniond>(21, nozzleDown()))});
  const JointPath path = plan(toolpath, machine);
  ASSERT_EQ(path.faults.size(), 4U);
  EXPECT_EQ(path.faults[0].at.waypoint, 11U);
  EXPECT_EQ(path.faults[0].reason, "joint x would have to be at 11 mm; its greatest value is 10.5 mm");
  for (std::size_t i = 0; i < path.values.size(); ++i)
    EXPECT_EQ(path.values[i].size() == 0, i >= 11 && i <= 14) << i;
}

TEST(JointPathPlanner, NamesALeapOfTheToolAxis) {
  const Toolpath toolpath =
      toolpathOf({pathThrough(PathRole::Infill, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
                              {inclined(0.0, 80.0), inclined(120.0, 80.0), inclined(120.0, 80.0)})});
  const JointPath path = plan(toolpath, GantryHead(ToolAxisSpin::Free));
  ASSERT_EQ(path.faults.size(), 1U);
  EXPECT_EQ(path.faults[0].fault, JointFault::Jump);
  EXPECT_EQ(path.faults[0].at.waypoint, 1U);
  EXPECT_EQ(path.faults[0].reason, "joint c would have to turn by 120 deg within 1 mm; at most 90 deg");
}

TEST(JointPathPlanner, NamesWhatIsNearerToASingularityThanAllowed) {
  JointPathSettings settings;
  settings.least_margin_deg = 5.0;
  const Toolpath toolpath = toolpathOf({pathThrough(PathRole::Infill, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
                                                    {inclined(0, 8.0), inclined(0, 4.0), inclined(0, 8.0)})});
  const JointPath path = plan(toolpath, GantryHead(ToolAxisSpin::Free), settings);
  ASSERT_EQ(path.faults.size(), 1U);
  EXPECT_EQ(path.faults[0].fault, JointFault::Singular);
  EXPECT_EQ(path.faults[0].reason, "4 deg from a singularity; must be 5 deg or more");
}

TEST(JointPathPlanner, IsTheSameWhateverTheNumberOfThreads) {
  const GantryHead machine(ToolAxisSpin::Given, 280.0);
  const Toolpath toolpath = tower(3);
  const JointPath many = plan(toolpath, machine);
  const ThreadLimit limit(1);
  const JointPath one = plan(toolpath, machine);
  ASSERT_EQ(many.values.size(), one.values.size());
  for (std::size_t i = 0; i < one.values.size(); ++i) EXPECT_EQ(many.values[i], one.values[i]);
  EXPECT_EQ(many.rewinds, one.rewinds);
}

TEST(JointPathPlanner, OfNothingIsEmpty) {
  const JointPath path = plan(Toolpath(), GantryHead(ToolAxisSpin::Free));
  EXPECT_TRUE(path.at.empty());
  EXPECT_TRUE(path.isRunnable());
}

TEST(JointPathPlanner, RefusesSettingsOutOfBounds) {
  JointPathSettings settings;
  settings.yaw_samples = 0;
  EXPECT_THROW(plan(Toolpath(), GantryHead(ToolAxisSpin::Free), settings), InvalidConfig);
}

TEST(JointPathPlanner, RefusesMotionsOfExternalAxesThatAreNotThere) {
  const GantryHead machine(ToolAxisSpin::Free);
  const auto refusal = [&](const JointPathSettings& settings) -> std::string {
    try {
      plan(toolpathOf({circle(0.0, 45.0)}), machine, settings);
    } catch (const InvalidConfig& error) {
      return error.what();
    }
    return "";
  };
  JointPathSettings settings;
  EXPECT_EQ(refusal(settings), "");
  settings.external = ExternalChoice::Gravity;
  EXPECT_EQ(refusal(settings),
            "joints.external is not held, but '" + machine.name() + "' has no external axes; expected held");
  settings.external = ExternalChoice::Held;
  settings.rail = RailChoice::Follow;
  EXPECT_EQ(refusal(settings),
            "joints.rail is not held, but '" + machine.name() + "' has no external axes; expected held");
}

/// Bans values of the last joint.
class BannedSpin : public JointGuard {
 public:
  BannedSpin(double around, double half_width) : around_(around), half_width_(half_width) {}
  bool allows(const JointValues& values) const override {
    return std::abs(std::remainder(values.tail<1>()[0] - around_, 2.0 * M_PI)) > half_width_;
  }
  std::string hindrance(const JointValues&) const override { return "the hose would be in the head"; }

 private:
  double around_;
  double half_width_;
};

JointPath planGuarded(const Toolpath& toolpath, const KinematicModel& model, const JointGuard& guard) {
  NoProgress progress;
  return planJointPath(toolpath, Eigen::Isometry3d::Identity(), {model, guard}, {}, progress);
}

TEST(JointPathPlanner, GoesRoundAYawThatIsBanned) {
  const GantryHead machine(ToolAxisSpin::Given, 400.0);
  const Toolpath toolpath = toolpathOf({circle(0.0, 90.0)});
  const JointPath free = plan(toolpath, machine);
  ASSERT_TRUE(free.isRunnable());
  const BannedSpin guard(free.values[10].tail<1>()[0], 30.0 * kDegree);
  const JointPath guarded = planGuarded(toolpath, machine, guard);
  ASSERT_TRUE(guarded.isRunnable());
  for (const JointValues& values : guarded.values) EXPECT_TRUE(guard.allows(values));
  EXPECT_LT(misses(guarded, toolpath, machine).tool_axis, 1e-9);
}

TEST(JointPathPlanner, NamesWaypointsWhoseEveryYawIsBanned) {
  const GantryHead machine(ToolAxisSpin::Given);
  const Toolpath toolpath = tower(1);
  const JointPath path = planGuarded(toolpath, machine, BannedSpin(0.0, 4.0));
  ASSERT_EQ(path.faults.size(), path.at.size());
  EXPECT_EQ(path.faults[0].fault, JointFault::SelfCollision);
  EXPECT_EQ(path.faults[0].reason, "the hose would be in the head");
}

}  // namespace
}  // namespace lamina
