// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/overhang/unsupported_surface.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/geometry/shortest_rotation.hpp"

namespace lamina {
namespace {

/// A plate of 40 x 20 mm over two pillars 10 mm high, 20 mm apart.
Mesh gate() { return makePart("bridge"); }

/// A wall round the middle of a box of 20 mm in each layer of 1 mm, with one tool axis.
Toolpath wallsAlong(const Point3& tool_axis) {
  Toolpath toolpath;
  for (int layer = 1; layer <= 20; ++layer) {
    const double k = layer;
    Path path;
    path.role = PathRole::OuterWall;
    path.is_closed = true;
    path.points = {{-10.0, -10.0, k}, {10.0, -10.0, k}, {10.0, 10.0, k}, {-10.0, 10.0, k}};
    path.orientation = AlongPath<Eigen::Quaterniond>(shortestRotation(Point3::UnitZ(), tool_axis));
    path.bead = Bead{0.8, 1.0};
    toolpath.layers.push_back({k, 1.0, {path}});
  }
  return toolpath;
}

TEST(UnsupportedSurface, OfAGateIsWhatSpansTheGap) {
  const UnsupportedSurface surface = unsupportedSurface(gate(), Point3::UnitZ(), {45.0, 0.2});
  EXPECT_NEAR(surface.unsupported_mm2, 20.0 * 20.0, 1e-6);
  EXPECT_NEAR(surfaceArea(surface.region), 400.0, 1e-6);
  // Two plates' sides of 40 x 20 without the pillars, their rims, and four walls of each pillar.
  EXPECT_NEAR(surface.surface_mm2, surfaceArea(gate()), 1e-6);
  EXPECT_NEAR(surface.percent(), 100.0 * 400.0 / surfaceArea(gate()), 1e-9);
}

TEST(UnsupportedSurface, WhatTheFirstLayerReachesRests) {
  EXPECT_EQ(unsupportedSurface(gate(), Point3::UnitZ(), {45.0, 10.0}).unsupported_mm2, 0.0);
  EXPECT_EQ(unsupportedSurface(makePart("box"), Point3::UnitZ(), {45.0, 0.2}).unsupported_mm2, 0.0);
}

TEST(UnsupportedSurface, AnAngleThatTheMaterialTakesIsSupported) {
  // The wall leans by 45 deg to rounding, from vertical.
  const Mesh funnel = makePart("cone", {{"radius_mm", "10"}, {"top_radius_mm", "20"}, {"height_mm", "10"}});
  EXPECT_EQ(unsupportedSurface(funnel, Point3::UnitZ(), {45.1, 0.2}).unsupported_mm2, 0.0);
  EXPECT_NEAR(unsupportedSurface(funnel, Point3::UnitZ(), {44.0, 0.2}).unsupported_mm2,
              M_PI * 30.0 * 10.0 * std::sqrt(2.0), 2.0);
}

// Layers that grow towards +x leave the side at -x unsupported, but for what rests on the bed.
TEST(UnsupportedSurface, FollowsTheToolAxis) {
  Mesh box = makePart("box");
  NoProgress nobody;
  const UnsupportedSurface level = unsupportedSurface(box, wallsAlong(-Point3::UnitZ()), {45.0, 1.0}, nobody);
  EXPECT_EQ(level.unsupported_mm2, 0.0);
  const UnsupportedSurface aside = unsupportedSurface(box, wallsAlong(-Point3::UnitX()), {45.0, 1.0}, nobody);
  EXPECT_NEAR(aside.unsupported_mm2, 400.0, 40.0);
  for (const Point3& vertex : aside.region.vertices) EXPECT_NEAR(vertex.x(), boundingBox(box).low.x(), 1e-9);
}

TEST(UnsupportedSurface, AToolpathThatDepositsNothingIsRefused) {
  NoProgress nobody;
  EXPECT_THROW(unsupportedSurface(makePart("box"), Toolpath{}, {}, nobody), InvalidInput);
}

/// Counts reports, and is cancelled from one on.
class CountedReports final : public Progress {
 public:
  explicit CountedReports(int cancelled_from) : cancelled_from_(cancelled_from) {}
  void report(const std::string& stage, double) override {
    EXPECT_EQ(stage, "overhang");
    ++reports_;
  }
  bool isCancelled() const override { return reports_ >= cancelled_from_; }
  int reports() const { return reports_; }

 private:
  int cancelled_from_;
  std::atomic<int> reports_{0};
};

TEST(UnsupportedSurface, ReportsAndIsCancelled) {
  const Toolpath walls = wallsAlong(-Point3::UnitZ());
  CountedReports watched(1000);
  unsupportedSurface(makePart("box"), walls, {}, watched);
  EXPECT_GE(watched.reports(), 100);
  for (const int from : {0, 1, 50}) {
    CountedReports cancelled(from);
    EXPECT_THROW(unsupportedSurface(makePart("box"), walls, {}, cancelled), Cancelled) << from;
  }
  CountedReports at_once(0);
  EXPECT_THROW(unsupportedSurface(makePart("box"), Toolpath{}, {}, at_once), Cancelled)
      << "before anything is looked at";
}

}  // namespace
}  // namespace lamina
