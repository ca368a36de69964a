// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/timing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// Two layers: a travel of 100 mm along x at 100 mm/s, then a wall of 50 mm along y at 50 mm/s.
Toolpath twoLayers() {
  Toolpath toolpath;
  for (int l = 0; l < 2; ++l) {
    const double z = 0.2 * (l + 1);
    Path travel;
    travel.role = PathRole::Travel;
    travel.points = {{0, 0, z}, {100, 0, z}};
    travel.feed_mm_s = 100.0;
    Path wall;
    wall.role = PathRole::OuterWall;
    wall.points = {{100, 0, z}, {100, 20, z}, {100, 20, z}, {100, 50, z}};
    wall.feed_mm_s = 50.0;
    wall.bead = Bead{0.4, 0.2};
    toolpath.layers.push_back({z, 0.2, {travel, wall}});
  }
  return toolpath;
}

MotionLimits almostStoppingAtCorners() {
  MotionLimits limits;
  limits.acceleration_mm_s2 = 500.0;
  limits.travel_acceleration_mm_s2 = 1000.0;
  limits.junction_deviation_mm = 1e-12;
  return limits;
}

// Rest to rest L / v + v / a: 1 + 0.1 s for each travel, 1 + 0.1 s for each wall.
constexpr double kLayerTime = 2.2;

TEST(Timing, EstimatesTheRestToRestTimes) {
  const ToolpathTime time = estimateTime(twoLayers(), almostStoppingAtCorners());
  EXPECT_NEAR(time.total_s, 2 * kLayerTime, 1e-3);
  ASSERT_EQ(time.layer_start_s.size(), 2U);
  EXPECT_DOUBLE_EQ(time.layer_start_s[0], 0.0);
  EXPECT_NEAR(time.layer_start_s[1], kLayerTime, 1e-3);
}

TEST(Timing, AnEmptyToolpathTakesNoTime) { EXPECT_EQ(estimateTime(Toolpath{}, MotionLimits{}).total_s, 0.0); }

TEST(ToolpathPlayer, StandsAtTheWaypointsAtTheirTimes) {
  const Toolpath toolpath = twoLayers();
  ToolpathPlayer player(toolpath, almostStoppingAtCorners());
  EXPECT_TRUE(player.at(-1.0).position.isApprox(Point3(0, 0, 0.2)));
  EXPECT_TRUE(player.at(0.55).position.isApprox(Point3(50, 0, 0.2), 1e-4));
  EXPECT_NEAR(player.at(0.55).speed_mm_s, 100.0, 1e-9);
  EXPECT_TRUE(player.at(1.1).position.isApprox(Point3(100, 0, 0.2), 1e-4));
  const NozzleSample late = player.at(2 * kLayerTime - 0.5);
  EXPECT_EQ(late.heading_for.layer, 1U);
  EXPECT_EQ(late.heading_for.path, 1U);
  EXPECT_EQ(late.heading_for.waypoint, 3U);
  EXPECT_FALSE(player.isFinished());
  EXPECT_TRUE(player.at(100.0).position.isApprox(Point3(100, 50, 0.4)));
  EXPECT_TRUE(player.isFinished());
}

TEST(ToolpathPlayer, ReportsWhenTheNextWaypointIsReached) {
  Toolpath toolpath = twoLayers();
  toolpath.layers.resize(1);
  ToolpathPlayer player(toolpath, almostStoppingAtCorners());
  EXPECT_TRUE(std::isinf(player.nextWaypointTime())) << "nothing runs yet";
  std::vector<Point3> reached = {player.at(0.0).position};
  EXPECT_NEAR(player.nextWaypointTime(), 1.1, 1e-3);
  while (std::isfinite(player.nextWaypointTime()))
    reached.push_back(player.at(player.nextWaypointTime()).position);
  EXPECT_TRUE(player.isFinished());
  std::vector<Point3> waypoints;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      for (const Point3& point : path.points)
        if (waypoints.empty() || point != waypoints.back()) waypoints.push_back(point);
  ASSERT_EQ(reached.size(), waypoints.size());
  for (std::size_t i = 0; i < reached.size(); ++i) EXPECT_LT((reached[i] - waypoints[i]).norm(), 1e-9) << i;
}

TEST(ToolpathPlayer, GoesBackInTime) {
  const Toolpath toolpath = twoLayers();
  ToolpathPlayer player(toolpath, almostStoppingAtCorners());
  player.at(100.0);
  EXPECT_TRUE(player.at(0.55).position.isApprox(Point3(50, 0, 0.2), 1e-4));
  EXPECT_FALSE(player.isFinished());
}

TEST(ToolpathPlayer, TurnsTheNozzleAlongAMotion) {
  Toolpath toolpath = twoLayers();
  toolpath.layers.resize(1);
  Path& travel = toolpath.layers[0].paths[0];
  const Eigen::Quaterniond tilted = nozzleDown() * Eigen::AngleAxisd(M_PI / 2, Point3::UnitX());
  travel.orientation = AlongPath<Eigen::Quaterniond>(std::vector<Eigen::Quaterniond>{nozzleDown(), tilted});
  ToolpathPlayer player(toolpath, almostStoppingAtCorners());
  EXPECT_NEAR(player.at(0.55).orientation.angularDistance(nozzleDown()), M_PI / 4, 1e-3);
}

TEST(ToolpathPlayer, RefusesAToolpathWithoutMotion) {
  const Toolpath toolpath;
  ToolpathPlayer player(toolpath, MotionLimits{});
  EXPECT_THROW(player.at(0.0), InvalidInput);
}

}  // namespace
}  // namespace lamina
