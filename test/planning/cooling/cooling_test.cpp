// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/cooling/cooling.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <variant>

#include "lamina/base/error.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/timing.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

/// A tower of 10 x 10 mm, two walls and nothing inside.
Toolpath tower(int layers = 6) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.infill.density = 0.0;
  settings.feed.first_layer_mm_s = 1000.0;
  return test::plan(test::layersOf(layers, [](int) { return std::vector<Polygon>{rectangle(0, 0, 10, 10)}; }),
                    settings);
}

/// So great that feeds alone count.
MotionLimits boundless() {
  MotionLimits limits;
  limits.acceleration_mm_s2 = limits.travel_acceleration_mm_s2 = 1e8;
  return limits;
}

CoolingSettings atLeast(double layer_time_s) {
  CoolingSettings settings;
  settings.least_layer_time_s = layer_time_s;
  return settings;
}

CoolingSummary cooled(Toolpath& toolpath, const CoolingSettings& settings,
                      const MotionLimits& limits = boundless()) {
  NoProgress nobody;
  const CoolingSummary summary = cool(toolpath, settings, limits, nobody);
  validate(toolpath);
  return summary;
}

double layerTime(const Toolpath& toolpath, std::size_t layer, const MotionLimits& limits = boundless()) {
  const ToolpathTime time = estimateTime(toolpath, limits);
  return time.layer_start_s.at(layer + 1) - time.layer_start_s.at(layer);
}

double leastFeed(const Toolpath& toolpath, PathRole role) {
  double least = 1e9;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role == role)
        for (const double feed : path.feed_mm_s.values()) least = std::min(least, feed);
  return least;
}

// Loops of 38.4 mm at 30 mm/s and of 35.54 mm at 45 mm/s: 2.07 s.
const double kInnerLoop = 4 * (9.6 - 2 * test::kLayerPitch);
const double kLayerTime = 38.4 / 30.0 + kInnerLoop / 45.0;

TEST(Cooling, ChangesNothingWhereLayersTakeLongEnough) {
  Toolpath toolpath = tower();
  const std::string id = toolpathId(toolpath);
  EXPECT_NEAR(layerTime(toolpath, 2), kLayerTime, 0.02);
  for (const double least_s : {0.0, 2.0}) {
    EXPECT_EQ(cooled(toolpath, atLeast(least_s)).slowed_layers, 0U);
    EXPECT_EQ(toolpathId(toolpath), id);
  }
}

TEST(Cooling, SlowsDownUntilALayerTakesItsTime) {
  Toolpath toolpath = tower();
  const CoolingSummary summary = cooled(toolpath, atLeast(5.0));
  EXPECT_EQ(summary.slowed_layers, 6U);
  EXPECT_EQ(summary.dwells, 0U);
  EXPECT_NEAR(layerTime(toolpath, 2), 5.0, 0.05);
  // The inner wall alone cannot: 38.4 / 30 + 35.54 / 10 is 4.83 s.
  EXPECT_NEAR(leastFeed(toolpath, PathRole::InnerWall), 10.0, 1e-9);
  EXPECT_NEAR(leastFeed(toolpath, PathRole::OuterWall), 38.4 / (5.0 - kInnerLoop / 10.0), 0.6);
}

TEST(Cooling, SlowsInnerWallsBeforeOuterOnes) {
  Toolpath toolpath = tower();
  cooled(toolpath, atLeast(4.0));
  EXPECT_NEAR(layerTime(toolpath, 2), 4.0, 0.04);
  EXPECT_EQ(leastFeed(toolpath, PathRole::OuterWall), 30.0);
  EXPECT_NEAR(leastFeed(toolpath, PathRole::InnerWall), kInnerLoop / (4.0 - 38.4 / 30.0), 0.3);
}

TEST(Cooling, WaitsForWhatTheLeastFeedLacks) {
  Toolpath toolpath = tower();
  const CoolingSummary summary = cooled(toolpath, atLeast(8.0));
  EXPECT_NEAR(layerTime(toolpath, 2), 8.0, 0.05);
  EXPECT_EQ(leastFeed(toolpath, PathRole::OuterWall), 10.0);
  EXPECT_EQ(leastFeed(toolpath, PathRole::InnerWall), 10.0);
  EXPECT_EQ(leastFeed(toolpath, PathRole::Travel), 150.0);
  EXPECT_EQ(summary.dwells, 5U) << "nobody waits for the last layer";
  const Path& last = toolpath.layers[2].paths.back();
  EXPECT_EQ(last.role, PathRole::Travel);
  EXPECT_TRUE(last.process.is_retracted);
  double highest = 0.0;
  double least_x = 1e9;
  for (const Point3& point : last.points) {
    highest = std::max(highest, point.z());
    least_x = std::min(least_x, point.x());
  }
  EXPECT_NEAR(highest, 0.6 + 2.0, 1e-9);
  EXPECT_LT(least_x, -4.0) << "beside the part";
  // Loops at 10 mm/s take 7.39 s; the ways beside the part and back a tenth.
  EXPECT_NEAR(summary.dwell_s / 5, 8.0 - (38.4 + kInnerLoop) / 10.0, 0.25);
}

/// Three lines of 10 mm, each of which begins 0.5 mm beside where the one below ended.
Toolpath linesAside() {
  Toolpath toolpath;
  for (int l = 0; l < 3; ++l) {
    const double z = 0.2 * (l + 1);
    const double y = 0.5 * l;
    Path bead;
    bead.role = PathRole::OuterWall;
    bead.bead = Bead{0.4, 0.2};
    bead.feed_mm_s = 10.0;
    bead.points = {{l % 2 == 0 ? 0.0 : 10.0, y, z}, {l % 2 == 0 ? 10.0 : 0.0, y, z}};
    ToolpathLayer layer{z, 0.2, {bead}};
    if (l > 0) {
      Path way = bead;
      way.role = PathRole::Travel;
      way.bead = Bead{};
      way.feed_mm_s = 100.0;
      way.points = {toolpath.layers.back().paths.back().points[1], bead.points[0]};
      layer.paths.insert(layer.paths.begin(), way);
    }
    toolpath.layers.push_back(layer);
  }
  return toolpath;
}

CoolingSettings waitingFor(double layer_time_s) {
  CoolingSettings settings = atLeast(layer_time_s);
  settings.by = CoolingBy::Dwell;
  return settings;
}

/// Material that is pushed forth over the last bead makes a blob there, and the nozzle drags through it.
TEST(Cooling, GoesOnFromAWaitToTheNextBead) {
  Toolpath toolpath = linesAside();
  const CoolingSummary summary = cooled(toolpath, waitingFor(5.0));
  EXPECT_EQ(summary.dwells, 2U);
  ASSERT_EQ(toolpath.layers[0].paths.size(), 2U);
  const Path& wait = toolpath.layers[0].paths[1];
  EXPECT_TRUE(wait.process.is_retracted);
  const std::vector<Point3> way = {{10, 0, 0.2}, {10, 0, 2.2}, {-5, 0, 2.2}, {10, 0.5, 2.2}, {10, 0.5, 0.4}};
  ASSERT_EQ(wait.points.size(), way.size());
  for (std::size_t i = 0; i < way.size(); ++i) EXPECT_NEAR((wait.points[i] - way[i]).norm(), 0.0, 1e-9) << i;
  EXPECT_EQ(wait.events.at(0).motion, 2U);
  ASSERT_EQ(toolpath.layers[1].paths.size(), 2U);
  EXPECT_EQ(toolpath.layers[1].paths[0].role, PathRole::OuterWall) << "the way there is gone";
  // 5 s and the way of 0.54 mm that stood in the next layer.
  EXPECT_NEAR(layerTime(toolpath, 0), 5.0 + std::hypot(0.5, 0.2) / 100.0, 1e-3);
}

/// The first layer is a bead alone, at 10 mm/s; the travels of others are at 100 mm/s.
TEST(Cooling, GoesToAWaitAsFastAsItTravelsInOtherLayers) {
  Toolpath toolpath = linesAside();
  cooled(toolpath, waitingFor(5.0));
  const Path& wait = toolpath.layers[0].paths.back();
  ASSERT_EQ(wait.role, PathRole::Travel);
  EXPECT_EQ(wait.feed_mm_s.at(0), 100.0);
}

TEST(Cooling, KeepsMaterialBackUntilTheNextBeadWhereItDoesNotRise) {
  Toolpath toolpath = linesAside();
  CoolingSettings settings = waitingFor(5.0);
  settings.park = ParkPlace::Stay;
  settings.lift_mm = 0.0;
  cooled(toolpath, settings);
  ASSERT_EQ(toolpath.layers[1].paths.size(), 3U);
  EXPECT_EQ(toolpath.layers[1].paths[0].role, PathRole::Travel);
  EXPECT_TRUE(toolpath.layers[1].paths[0].process.is_retracted);
}

TEST(Cooling, WaitsOnTheSpotForAllThatTheLeastFeedLacks) {
  Toolpath toolpath = tower();
  CoolingSettings settings = atLeast(8.0);
  settings.park = ParkPlace::Stay;
  settings.lift_mm = 0.0;
  const CoolingSummary summary = cooled(toolpath, settings);
  EXPECT_NEAR(layerTime(toolpath, 2), 8.0, 0.05);
  EXPECT_NEAR(summary.dwell_s / 5, 0.61, 0.02)
      << "8 s less the loops at 10 mm/s, 7.39 s, and the way to the next";
}

// Beside the part, a nozzle that leans may be in it: it waits out along its own axis.
TEST(Cooling, WaitsAlongTheToolAxisWhereItLeans) {
  const double lean = M_PI / 3.0;
  const Eigen::Quaterniond held = Eigen::AngleAxisd(lean, Point3::UnitX()) * nozzleDown();
  Toolpath toolpath = withNozzle(tower(), held);
  CoolingSettings settings = atLeast(1000.0);
  settings.park = ParkPlace::Outside;
  cooled(toolpath, settings);
  int waits = 0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      const bool waits_here = std::any_of(path.events.begin(), path.events.end(), [](const PathEvent& event) {
        return std::holds_alternative<Dwell>(event.event);
      });
      if (!waits_here) continue;
      ++waits;
      ASSERT_EQ(path.points.size(), 3U);
      EXPECT_EQ(path.events.back().motion, 1U);
      // Against a tool axis that leans by 60 deg: (0, -sin 60, cos 60).
      const Point3 out = path.points[1] - path.points[0];
      EXPECT_NEAR((out.normalized() - Point3(0.0, -std::sin(lean), std::cos(lean))).norm(), 0.0, 1e-9);
      EXPECT_GE(out.norm(), 5.0 - 1e-9);
      EXPECT_EQ(path.points[2], path.points[0]);
    }
  EXPECT_GE(waits, 5);
}

TEST(Cooling, OnlyWaitsWhereFeedsBelongToTheProcess) {
  Toolpath toolpath = tower();
  CoolingSettings settings = atLeast(20.0);
  settings.by = CoolingBy::Dwell;
  settings.park = ParkPlace::Stay;
  settings.lift_mm = 0.0;
  const CoolingSummary summary = cooled(toolpath, settings);
  EXPECT_EQ(summary.slowed_layers, 0U);
  EXPECT_NEAR(layerTime(toolpath, 2), 20.0, 0.05);
  EXPECT_EQ(leastFeed(toolpath, PathRole::OuterWall), 30.0);
}

TEST(Cooling, ReportsLayersThatAreTooFastEvenAtTheLeastFeed) {
  Toolpath toolpath = tower();
  CoolingSettings settings = atLeast(8.0);
  settings.by = CoolingBy::Slow;
  EXPECT_EQ(cooled(toolpath, settings).too_fast_layers, 5U);
  EXPECT_NEAR(layerTime(toolpath, 2), (38.4 + kInnerLoop) / 10.0, 0.05);
}

TEST(Cooling, CountsAccelerations) {
  MotionLimits limits;
  limits.acceleration_mm_s2 = 200.0;
  Toolpath toolpath = tower();
  cooled(toolpath, atLeast(5.0), limits);
  EXPECT_NEAR(layerTime(toolpath, 2, limits), 5.0, 0.15);
}

TEST(Fan, FollowsTheTimeOfTheLayer) {
  const FanSettings settings;
  EXPECT_EQ(fanShare(5.0, 0, settings), 0.0);
  EXPECT_EQ(fanShare(1.0, 1, settings), 1.0);
  EXPECT_EQ(fanShare(5.0, 1, settings), 1.0);
  EXPECT_NEAR(fanShare(32.5, 1, settings), 0.675, 1e-12);
  EXPECT_NEAR(fanShare(60.0, 1, settings), 0.35, 1e-12);
  EXPECT_NEAR(fanShare(61.0, 1, settings), 0.35, 1e-12);
  FanSettings off = settings;
  off.beyond = FanSettings::WhenSlow::None;
  EXPECT_EQ(fanShare(61.0, 1, off), 0.0);
}

TEST(Fan, IsAnEventWhereItChanges) {
  Toolpath toolpath = tower();
  const std::string id = toolpathId(toolpath);
  addFan(toolpath, FanSettings{}, boundless());
  EXPECT_EQ(toolpathId(toolpath), id) << "off is gone";
  FanSettings on;
  on.is_used = true;
  addFan(toolpath, on, boundless());
  validate(toolpath);
  for (std::size_t l = 0; l < 6; ++l) {
    const auto& events = toolpath.layers[l].paths.front().events;
    ASSERT_EQ(events.size(), l == 1 ? 1U : 0U) << l;
    if (l == 1) {
      EXPECT_EQ(std::get<FanShare>(events[0].event).share, 1.0) << "2 s a layer";
    }
  }
  ASSERT_EQ(toolpath.events_at_end.size(), 1U);
  EXPECT_EQ(std::get<FanShare>(toolpath.events_at_end[0]).share, 0.0);
}

/// Shares in the order in which they are sent in a layer, each with the role that it is sent before.
std::vector<std::pair<PathRole, double>> sharesOf(const ToolpathLayer& layer) {
  std::vector<std::pair<PathRole, double>> shares;
  for (const Path& path : layer.paths)
    for (const PathEvent& each : path.events)
      shares.emplace_back(path.role, std::get<FanShare>(each.event).share);
  return shares;
}

TEST(Fan, HasSharesOverNothing) {
  Path wall;
  wall.role = PathRole::OuterWall;
  wall.points = {{0, 0, 1}, {10, 0, 1}, {20, 0, 1}, {30, 0, 1}};
  wall.bead = Bead{0.4, 0.2};
  wall.feed_mm_s = 1.0;
  wall.values = {{"unsupported", AlongPath<double>(std::vector<double>{0, 0, 0.6, 0})}};
  Path bridge = wall;
  bridge.role = PathRole::Bridge;
  bridge.values.clear();
  bridge.points = {{30, 0, 1}, {60, 0, 1}};
  Path infill = bridge;
  infill.role = PathRole::Infill;
  infill.points = {{60, 0, 1}, {90, 0, 1}};
  Toolpath toolpath;
  toolpath.layers = {{1.0, 0.2, {wall, bridge, infill}}};
  FanSettings settings;
  settings.is_used = true;
  settings.off_layers = 0;
  settings.bridge = 0.9;
  settings.overhang = 0.6;  // 90 s: the layer has 0.35
  addFan(toolpath, settings, boundless());
  validate(toolpath);
  const std::vector<std::pair<PathRole, double>> wanted = {{PathRole::OuterWall, 0.35},
                                                           {PathRole::OuterWall, 0.6},
                                                           {PathRole::OuterWall, 0.35},
                                                           {PathRole::Bridge, 0.9},
                                                           {PathRole::Infill, 0.35}};
  EXPECT_EQ(sharesOf(toolpath.layers[0]), wanted);
  const std::vector<PathEvent>& events = toolpath.layers[0].paths[0].events;
  EXPECT_EQ(events[1].motion, 1U);
  EXPECT_EQ(events[2].motion, 2U);
  EXPECT_TRUE(toolpath.layers[0].paths[0].values.empty()) << "no program has a word for it";
}

TEST(Fan, RefusesBoundsThatContradict) {
  FanSettings settings;
  settings.least = 0.9;
  settings.greatest = 0.5;
  EXPECT_THROW(requireConsistent(settings), InvalidConfig);
  settings = {};
  settings.full_below_s = 70.0;
  EXPECT_THROW(requireConsistent(settings), InvalidConfig);
}

}  // namespace
}  // namespace lamina
