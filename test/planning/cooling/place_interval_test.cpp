// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Islands that are left alone for a time before the next layer comes.
#include <gtest/gtest.h>

#include <optional>

#include "lamina/base/error.hpp"
#include "lamina/planning/cooling/cooling.hpp"
#include "lamina/toolpath/timing.hpp"

namespace lamina {
namespace {

/// A loop of 12 s round a tower.
Path towerLoop(double x_mm, double z_mm) {
  Path path;
  path.role = PathRole::OuterWall;
  path.is_closed = true;
  path.points = {{x_mm, 0, z_mm}, {x_mm + 10, 0, z_mm}, {x_mm + 10, 10, z_mm}, {x_mm, 10, z_mm}};
  path.bead = Bead{1.0, 0.5};
  path.feed_mm_s = 40.0 / 12.0;
  return path;
}

Path wayBetween(const Point3& from, const Point3& to) {
  Path path;
  path.role = PathRole::Travel;
  path.process.is_retracted = true;
  path.points = {from, to};
  path.feed_mm_s = 1e6;
  return path;
}

/// Layers of loops at these places, in this order.
Toolpath towers(const std::vector<std::vector<double>>& layers_x_mm) {
  Toolpath toolpath;
  std::optional<Point3> nozzle;
  for (std::size_t l = 0; l < layers_x_mm.size(); ++l) {
    ToolpathLayer layer{0.5 * static_cast<double>(l + 1), 0.5, {}};
    for (const double x_mm : layers_x_mm[l]) {
      const Path loop = towerLoop(x_mm, layer.z_mm);
      if (nozzle) layer.paths.push_back(wayBetween(*nozzle, loop.firstPoint()));
      nozzle = loop.lastPoint();
      layer.paths.push_back(loop);
    }
    toolpath.layers.push_back(layer);
  }
  return toolpath;
}

CoolingSettings aloneFor(double seconds) {
  CoolingSettings settings;
  settings.interval = CoolingInterval::Place;
  settings.by = CoolingBy::Dwell;
  settings.park = ParkPlace::Stay;
  settings.lift_mm = 0.0;
  settings.least_layer_time_s = seconds;
  return settings;
}

MotionLimits instantMotion() {
  MotionLimits limits;
  limits.acceleration_mm_s2 = limits.travel_acceleration_mm_s2 = 1e12;
  return limits;
}

CoolingSummary leftAlone(Toolpath& toolpath, const CoolingSettings& settings) {
  NoProgress nobody;
  const CoolingSummary summary = cool(toolpath, settings, instantMotion(), nobody);
  validate(toolpath);
  return summary;
}

/// Where loops begin, layer by layer [mm].
std::vector<std::vector<double>> orderOf(const Toolpath& toolpath) {
  std::vector<std::vector<double>> order;
  for (const ToolpathLayer& layer : toolpath.layers) {
    order.emplace_back();
    for (const Path& path : layer.paths)
      if (path.role == PathRole::OuterWall) order.back().push_back(path.firstPoint().x());
  }
  return order;
}

/// Pauses between leaving a tower and coming back to it, layer by layer, at least.
double shortestPause(const Toolpath& toolpath) {
  const PathTimes times = estimatePathTimes(toolpath, instantMotion());
  double least = 1e9;
  for (std::size_t l = 1; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p)
      for (std::size_t q = 0; q < toolpath.layers[l - 1].paths.size(); ++q) {
        const Path& above = toolpath.layers[l].paths[p];
        const Path& below = toolpath.layers[l - 1].paths[q];
        if (above.role != PathRole::OuterWall || below.role != PathRole::OuterWall) continue;
        if (above.firstPoint().x() != below.firstPoint().x()) continue;
        least = std::min(least, times.start_s[l][p] - times.start_s[l - 1][q] - 12.0);
      }
  return least;
}

TEST(PlaceInterval, WaitsForWhatTheOtherTowerLeaves) {
  Toolpath toolpath = towers({{0, 30}, {0, 30}, {0, 30}, {0, 30}});
  const CoolingSummary summary = leftAlone(toolpath, aloneFor(20.0));
  EXPECT_EQ(summary.dwells, 3U);
  EXPECT_NEAR(summary.dwell_s, 3 * 8.0, 0.01) << "8 s a layer, not 16";
  EXPECT_EQ(summary.reordered_layers, 0U);
  EXPECT_NEAR(shortestPause(toolpath), 20.0, 0.01);
  EXPECT_NEAR(estimateTime(toolpath, instantMotion()).total_s, 4 * 24.0 + 3 * 8.0, 0.05);
}

TEST(PlaceInterval, LaysWhatWasLeftFirstFirst) {
  Toolpath toolpath = towers({{0, 30}, {30, 0}, {0, 30}, {30, 0}, {0, 30}});
  const CoolingSummary summary = leftAlone(toolpath, aloneFor(20.0));
  const std::vector<double> first{0, 30};
  EXPECT_EQ(orderOf(toolpath), (std::vector<std::vector<double>>(5, first)));
  EXPECT_EQ(summary.reordered_layers, 2U);
  EXPECT_NEAR(summary.dwell_s, 4 * 8.0, 0.01);
  EXPECT_NEAR(shortestPause(toolpath), 20.0, 0.01);
}

TEST(PlaceInterval, KeepsTheOrderOfMarkedParts) {
  Toolpath toolpath = towers({{0, 30}, {30, 0}});
  PathEvent mark;
  mark.event.emplace<PartMark>(PartMark{"left"});
  toolpath.layers[1].paths.back().events.push_back(mark);
  const CoolingSummary summary = leftAlone(toolpath, aloneFor(20.0));
  EXPECT_EQ(summary.reordered_layers, 0U);
  EXPECT_EQ(orderOf(toolpath)[1], (std::vector<double>{30, 0}));
  // Before the right tower, over which the nozzle stays; the left one is cool by then.
  EXPECT_NEAR(summary.dwell_s, 20.0, 0.01);
  EXPECT_NEAR(estimateTime(toolpath, instantMotion()).total_s, 4 * 12.0 + 20.0, 0.05);
}

TEST(PlaceInterval, OfASingleTowerIsWaitedForWhole) {
  Toolpath toolpath = towers({{0}, {0}, {0}});
  EXPECT_NEAR(leftAlone(toolpath, aloneFor(20.0)).dwell_s, 2 * 20.0, 0.01);
}

TEST(PlaceInterval, ChangesNothingWhereItIsShort) {
  Toolpath toolpath = towers({{0, 30}, {0, 30}, {0, 30}});
  const std::string id = toolpathId(toolpath);
  EXPECT_EQ(leftAlone(toolpath, aloneFor(11.0)).dwells, 0U);
  EXPECT_EQ(toolpathId(toolpath), id);
}

TEST(PlaceInterval, NeverWaitsForWhatBeginsAnew) {
  Toolpath toolpath = towers({{0}, {30}, {60}});
  EXPECT_EQ(leftAlone(toolpath, aloneFor(20.0)).dwells, 0U);
}

TEST(PlaceInterval, RemembersPlacesThatLayersInBetweenLeaveOut) {
  // As on a plate of parts whose layers are not as high.
  Toolpath toolpath = towers({{0}, {30}, {0}, {30}});
  const CoolingSummary summary = leftAlone(toolpath, aloneFor(20.0));
  EXPECT_EQ(summary.dwells, 1U) << "the second tower has been left for as long by then";
  EXPECT_NEAR(summary.dwell_s, 20.0 - 12.0, 0.01);
}

TEST(PlaceInterval, CountsNoWaitThatTheWaysTake) {
  CoolingSettings settings = aloneFor(0.001);
  settings.lift_mm = 1.0;
  Toolpath toolpath = towers({{0}, {0}});
  for (Path& path : toolpath.layers[1].paths)
    if (path.role == PathRole::Travel) path.feed_mm_s = 1.0;
  toolpath.layers[0].paths.front().is_closed = true;
  EXPECT_EQ(leftAlone(toolpath, settings).dwells, 0U);
}

TEST(PlaceInterval, LeavesOutTheWipeBehindWhatComesLastNoMore) {
  Toolpath toolpath = towers({{0, 30}, {30, 0}, {0, 30}});
  // Along the loop that ends the second layer.
  const Path last = toolpath.layers[1].paths.back();
  const Path wipe = wayBetween(last.points[0], last.points[0] + Point3(2, 0, 0));
  toolpath.layers[1].paths.push_back(wipe);
  toolpath.layers[2].paths.front() = wayBetween(wipe.lastPoint(), toolpath.layers[2].paths[1].firstPoint());
  const CoolingSummary summary = leftAlone(toolpath, aloneFor(20.0));
  EXPECT_EQ(orderOf(toolpath)[1], (std::vector<double>{0, 30}));
  EXPECT_EQ(summary.reordered_layers, 1U);
  for (const Path& path : toolpath.layers[1].paths) EXPECT_NE(path.points, wipe.points);
  EXPECT_NEAR(shortestPause(toolpath), 20.0, 0.01);
}

TEST(PlaceInterval, CountsIslandsWhoseBoxesOverlapAsOne) {
  Toolpath toolpath = towers({{0, 9}, {0, 9}});
  EXPECT_NEAR(leftAlone(toolpath, aloneFor(20.0)).dwell_s, 20.0, 0.01);
}

TEST(PlaceInterval, IsRefusedWithSlowerFeeds) {
  CoolingSettings settings = aloneFor(20.0);
  EXPECT_NO_THROW(requireConsistent(settings));
  for (const CoolingBy by : {CoolingBy::Slow, CoolingBy::SlowThenDwell}) {
    settings.by = by;
    EXPECT_THROW(requireConsistent(settings), InvalidConfig);
  }
}

}  // namespace
}  // namespace lamina
