// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/travel/wipes.hpp"

#include <gtest/gtest.h>

#include "lamina/toolpath/wipe.hpp"
#include "planning/travel/travel.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

Path depositedRun(bool is_closed) {
  Path path;
  path.is_closed = is_closed;
  path.points = {{0, 0, 0.2}, {10, 0, 0.2}, {10, 1, 0.2}, {0, 1, 0.2}};
  path.bead = Bead{0.4, 0.2};
  path.feed_mm_s = 45.0;
  return path;
}

/// A run, a travel of 20 mm and another run.
std::vector<ToolpathLayer> wiped(bool is_closed, const TravelSettings& settings) {
  const Path first = depositedRun(is_closed);
  Path second = depositedRun(true);
  for (Point3& point : second.points) point.x() += 30.0;
  Toolpath toolpath;
  toolpath.layers = {
      {0.2, 0.2, {first, makeTravel(first.lastPoint(), second.firstPoint(), settings).value(), second}}};
  addWipes(toolpath.layers, settings);
  validate(toolpath);
  return toolpath.layers;
}

TravelSettings wiping(double wipe_mm) {
  TravelSettings settings;
  settings.wipe_mm = wipe_mm;
  return settings;
}

TEST(Wiping, GoesBackAlongAnOpenRun) {
  const std::vector<Path> paths = wiped(false, wiping(3.0))[0].paths;
  ASSERT_EQ(paths.size(), 4U);
  EXPECT_EQ(paths[1].points, (std::vector<Point3>{{0, 1, 0.2}, {3, 1, 0.2}}));
  EXPECT_EQ(paths[1].role, PathRole::Travel);
  EXPECT_TRUE(paths[1].process.is_retracted);
  EXPECT_EQ(paths[1].feed_mm_s.at(1), 45.0);
  EXPECT_EQ(wipeShare(paths[1]), 0.7);
  EXPECT_TRUE(paths[2].process.is_retracted);
  EXPECT_EQ(paths[2].firstPoint(), Point3(3, 1, 0.2));
  EXPECT_EQ(paths[2].points[1], Point3(3, 1, 0.4)) << "it hops from where the wipe ends";
}

TEST(Wiping, GoesOnAlongALoopAndRoundItsCorners) {
  const std::vector<Path> paths = wiped(true, wiping(12.0))[0].paths;
  ASSERT_EQ(paths.size(), 4U);
  EXPECT_EQ(paths[1].points, (std::vector<Point3>{{0, 0, 0.2}, {10, 0, 0.2}, {10, 1, 0.2}, {9, 1, 0.2}}));
}

TEST(Wiping, EndsWhereTheRunDoes) {
  EXPECT_NEAR(length(wiped(false, wiping(100.0))[0].paths[1]), 21.0, 1e-12);
  EXPECT_NEAR(length(wiped(true, wiping(100.0))[0].paths[1]), 22.0, 1e-12);
}

TEST(Wiping, IsNotBeforeTravelsThatAreNotRetracted) {
  TravelSettings settings = wiping(3.0);
  settings.retraction_threshold_mm = 100.0;
  EXPECT_EQ(wiped(false, settings)[0].paths.size(), 3U);
}

TEST(Wiping, EndsTheLayerBeforeATravelToTheNext) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.infill.density = 0.0;
  settings.travel.retraction_threshold_mm = 0.0;
  const auto layers =
      test::layersOf(3, [](int) { return std::vector<Polygon>{test::rectangle(0, 0, 10, 10)}; });
  const Toolpath without = test::plan(layers, settings);
  settings.travel.wipe_mm = 2.0;
  const Toolpath with = test::plan(layers, settings);
  const Path& last = with.layers[0].paths.back();
  EXPECT_EQ(last.role, PathRole::Travel);
  EXPECT_NEAR(length(last), 2.0, 1e-9);
  EXPECT_NEAR(last.points.back().z(), 0.2, 1e-12);
  EXPECT_NEAR(totals(with).deposited_mm3, totals(without).deposited_mm3, 1e-9);
}

}  // namespace
}  // namespace lamina
