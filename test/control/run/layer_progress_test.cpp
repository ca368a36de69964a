// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/layer_progress.hpp"

#include <gtest/gtest.h>

#include "lamina/control/run/stuck_watch.hpp"
#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

TEST(LayerProgress, GoesFromBeadToScanToTheNextLayer) {
  test::SensedWallCase wall;
  wall.layers = 2;
  const Toolpath toolpath = test::scannedWall(wall);
  LayerProgress progress(toolpath, {});
  EXPECT_TRUE(progress.hasScan(0));
  const auto go = [&](const Point3& from, const Point3& to) {
    for (int i = 0; i <= 100; ++i) progress.observe(from + (to - from) * (i / 100.0));
    return progress.place();
  };
  PrintPosition place = go({0, 0, 1.5}, {30, 0, 1.5});
  EXPECT_EQ(place.layer, 0U);
  EXPECT_EQ(place.path, 0U);
  EXPECT_NEAR(place.along_mm, 30.0, 1e-9);
  EXPECT_FALSE(place.is_scanning);
  go({30, 0, 1.5}, {60, 0, 1.5});
  place = go({60, 0, 1.5}, {60, 0, 6.5});
  EXPECT_EQ(place.path, 1U);
  EXPECT_TRUE(place.is_scanning);
  EXPECT_NEAR(place.along_mm, 5.0, 1e-9);
  go({60, 0, 6.5}, {0, 0, 6.5});
  // A tenth of a millimetre before the layer's end it is over: machines do not report every corner.
  place = go({0, 0, 6.5}, {0, 0, 3.1});
  EXPECT_EQ(place.layer, 1U);
  EXPECT_EQ(place.path, 0U);
  EXPECT_FALSE(place.is_scanning);
  place = go({0, 0, 3.0}, {20, 0, 3.0});
  EXPECT_EQ(place.layer, 1U);
  EXPECT_NEAR(place.along_mm, 20.0, 1e-9);
}

TEST(LayerProgress, OfATravelBetweenBeadsIsNoScan) {
  Toolpath toolpath;
  Path bead;
  bead.role = PathRole::OuterWall;
  bead.bead = Bead{1.0, 0.5};
  bead.feed_mm_s = 10.0;
  bead.points = {{0, 0, 0.5}, {10, 0, 0.5}};
  Path travel = bead;
  travel.role = PathRole::Travel;
  travel.bead = Bead{};
  travel.points = {{10, 0, 0.5}, {10, 5, 0.5}};
  Path second = bead;
  second.points = {{10, 5, 0.5}, {0, 5, 0.5}};
  toolpath.layers.push_back({0.5, 0.5, {bead, travel, second}});
  const LayerProgress progress(toolpath, {});
  EXPECT_FALSE(progress.hasScan(0));
  EXPECT_FALSE(progress.hasScans());
}

std::vector<Point3> line(double depth) { return std::vector<Point3>(40, Point3(0.5, 0.0, depth)); }

TEST(StuckWatch, NeedsProfilesThatAreTheSame) {
  StuckWatch watch;
  for (int i = 0; i < 60; ++i) watch.see(line(60.0 + 1e-4 * i));
  EXPECT_EQ(watch.profiles(), 1) << "a tenth of a micrometre is news";
  for (int i = 0; i < 60; ++i) watch.see(line(60.0));
  EXPECT_GE(watch.profiles(), 60);
  EXPECT_LT(watch.variance(), 1e-9);
  watch.see({});
  EXPECT_GE(watch.profiles(), 60) << "out of range";
  watch.see(line(61.0));
  EXPECT_EQ(watch.profiles(), 1);
}

TEST(StuckWatch, KnowsSeveralSensorsThatAreStuck) {
  StuckWatch watch;
  for (int i = 0; i < 50; ++i) {
    watch.see(line(60.0));
    watch.see(line(70.0));
    watch.see(line(80.0));
  }
  EXPECT_EQ(watch.profiles(), 148) << "all but the first two";
  watch.see(line(61.0));
  EXPECT_EQ(watch.profiles(), 1);
  for (int i = 0; i < 60; ++i) watch.see(line(60.0 + 0.01 * i));
  EXPECT_EQ(watch.profiles(), 1) << "news each";
}

TEST(StuckWatch, TakesZerosAndNoNumbersForNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  StuckWatch watch;
  for (int i = 0; i < 50; ++i)
    watch.see(std::vector<Point3>(static_cast<std::size_t>(5 + i % 3), Point3::Zero()));
  EXPECT_EQ(watch.profiles(), 50);
  for (int i = 0; i < 10; ++i) watch.see(std::vector<Point3>(5, Point3(nan, nan, nan)));
  EXPECT_EQ(watch.profiles(), 60);
}

}  // namespace
}  // namespace lamina
