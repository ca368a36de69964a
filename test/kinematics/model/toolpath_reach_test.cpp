// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/model/toolpath_reach.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// A toolpath of one travel through these points, nozzle straight down.
Toolpath through(const std::vector<Point3>& points) {
  Path path;
  path.role = PathRole::Travel;
  path.points = points;
  path.feed_mm_s = 100.0;
  Toolpath toolpath;
  toolpath.layers.push_back({points[0].z(), 0.2, {path}});
  return toolpath;
}

std::string unreachable(const Toolpath& toolpath, const BuildSpace& space) {
  try {
    requireReachable(toolpath, Eigen::Isometry3d::Identity(), space);
    return "";
  } catch (const Unreachable& error) {
    return error.what();
  }
}

TEST(ToolpathReach, NamesTheFirstWaypointOutOfReach) {
  const BuildSpace space = buildSpaceByName("cartesian_gantry");
  EXPECT_EQ(unreachable(through({{0, 0, 0}, {220, 220, 250}}), space), "");
  EXPECT_EQ(unreachable(through({{0, 0, 0}, {0, 230.5, 0}, {-1, 0, 0}}), space),
            "layer 0, path 0, waypoint 1: axis y would be at 230.500 mm; cartesian_gantry reaches 0.000 to "
            "220.000 mm");
  EXPECT_NE(unreachable(through({{0, 0, 0}, {0, 0, std::nan("")}}), space), "");
}

/// The head of a tool whose tip is 30 mm to the right stands 30 mm to the left of it.
TEST(ToolpathReach, CountsTheOffsetsOfTools) {
  const BuildSpace space = buildSpaceByName("cartesian_gantry");
  const auto reached = [&](Toolpath toolpath, std::uint32_t tool) {
    toolpath.layers[0].paths[0].tool = tool;
    try {
      requireReachable(toolpath, Eigen::Isometry3d::Identity(), space, {Point3::Zero(), Point3(30, -10, 0)});
      return std::string();
    } catch (const Unreachable& error) {
      return std::string(error.what());
    }
  };
  const Toolpath aside = through({{40, 100, 0}, {20, 100, 0}});
  EXPECT_EQ(reached(aside, 0), "");
  EXPECT_EQ(reached(aside, 1),
            "layer 0, path 0, waypoint 1: with the offset of tool 1, axis x would be at -10.000 mm; "
            "cartesian_gantry reaches 0.000 to 220.000 mm");
  EXPECT_EQ(reached(aside, 2), "") << "of which nothing is known";
  EXPECT_EQ(reached(through({{240, 100, 0}, {250, 100, 0}}), 1), "");
  EXPECT_NE(reached(through({{240, 100, 0}, {250, 100, 0}}), 0), "");
  EXPECT_NE(reached(through({{100, 211, 0}}), 1).find("axis y would be at 221.000 mm"), std::string::npos);
}

TEST(ToolpathReach, RefusesAnotherAngleOfTheNozzle) {
  EXPECT_EQ(unreachable(through({{0, 0, 0}, {10, 10, 10}}), buildSpaceByName("gantry_45")),
            "layer 0, path 0, waypoint 0: the nozzle would have to turn by 45.000 deg; the head of gantry_45 "
            "is fixed");
}

TEST(ToolpathReach, RefusesToTiltItsNozzleByItsLinearAxesAlone) {
  Toolpath tilted = through({{0, 0, 0}, {10, 10, 10}});
  tilted.layers[0].paths[0].orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.75 * M_PI, Point3::UnitX()));
  EXPECT_EQ(unreachable(tilted, buildSpaceByName("five_axis_head_table")),
            "layer 0, path 0, waypoint 0: the nozzle would have to turn by 45.000 deg; the linear axes of "
            "five_axis_head_table alone hold it as it is with joints c and b at zero");
}

TEST(ToolpathReach, LetsTheNozzleTurnAboutItsToolAxis) {
  Toolpath turned = through({{1, 2, 3}, {10, 10, 10}});
  turned.layers[0].paths[0].orientation =
      nozzleDown() * Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Point3::UnitZ()));
  EXPECT_EQ(unreachable(turned, buildSpaceByName("cartesian_gantry")), "");
}

TEST(ToolpathReach, GoesAlongABeltWithoutEnd) {
  const BuildSpace belt = buildSpaceByName("belt_45");
  Toolpath along = through({{0, 0, 0}, {0, -5e6, 0}});  // the belt is described as 1 km long
  along.layers[0].paths[0].orientation = Eigen::Quaterniond(belt.bed_from_nozzle);
  EXPECT_EQ(unreachable(along, belt), "");
  along.layers[0].paths[0].points.back().y() = 5.0;
  EXPECT_EQ(unreachable(along, belt),
            "layer 0, path 0, waypoint 1: axis z would be at -5.000 mm; belt_45 reaches 0.000 mm "
            "and on");
}

TEST(ToolpathReach, OfARobotIsTheRoomOverItsBed) {
  const BuildSpace space = buildSpaceByName("irb_4600");
  EXPECT_EQ(unreachable(through({{-400, 400, 0}, {400, -400, 1500}}), space), "");
  EXPECT_EQ(
      unreachable(through({{0, 0, 0}, {-400.5, 0, 0}}), space),
      "layer 0, path 0, waypoint 1: axis x would be at -400.500 mm; irb_4600 reaches -400.000 to 400.000 "
      "mm");
}

TEST(ToolpathReach, OfTipsAloneLetsTheToolAxisTurn) {
  const BuildSpace space = buildSpaceByName("cartesian_gantry");
  Toolpath tilted = through({{0, 0, 0}, {10, 10, 10}});
  tilted.layers[0].paths[0].orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.75 * M_PI, Point3::UnitX()));
  EXPECT_NE(unreachable(tilted, space), "");
  EXPECT_NO_THROW(requireTipsReachable(tilted, Eigen::Isometry3d::Identity(), space));
  EXPECT_NEAR(greatestToolAxisTurn(tilted, Eigen::Isometry3d::Identity(), space), 0.25 * M_PI, 1e-12);
  tilted.layers[0].paths[0].points.back().x() = 221.0;
  EXPECT_THROW(requireTipsReachable(tilted, Eigen::Isometry3d::Identity(), space), Unreachable);
}

}  // namespace
}  // namespace lamina
