// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/lift/height_field_lift.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/planning/planner.hpp"
#include "support/solid_under.hpp"

namespace lamina {
namespace {

constexpr double kSlope = 0.2;

double roofAt(double x) { return 6.0 + kSlope * x; }

Toolpath planned(const Mesh& mesh, const PlanSettings& settings) {
  NoProgress progress;
  const HeightFieldSlices slices = sliceByHeightField(mesh, {}, {}, progress);
  LiftSettings lift;
  lift.tool_axis = ToolAxis::Down;
  Toolpath toolpath =
      planPart("part", slices.layers, settings, {heightFieldLift(slices, lift, settings.travel)}, progress)
          .toolpath;
  validate(toolpath);
  return toolpath;
}

Mesh roof() {
  return test::solidUnder({16.0, 10.0}, 1, 1, [](double x, double) { return roofAt(x); });
}

PlanSettings solid() {
  PlanSettings settings;
  settings.infill.density = 1.0;
  return settings;
}

TEST(HeightFieldLift, LaysTheLastLayerOfARoofOnIt) {
  const Toolpath toolpath = planned(roof(), solid());
  ASSERT_FALSE(toolpath.layers.back().paths.empty());
  for (const Path& path : toolpath.layers.back().paths) {
    if (path.role == PathRole::Travel) continue;
    for (const Point3& point : path.points) EXPECT_NEAR(point.z(), roofAt(point.x()), 1e-4);
  }
}

TEST(HeightFieldLift, HoldsTheNozzleUpright) {
  const Toolpath toolpath = planned(roof(), solid());
  ASSERT_FALSE(toolpath.layers.front().paths.empty());
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      ASSERT_TRUE(path.orientation.isCommon());
      EXPECT_EQ(path.orientation.at(0).coeffs(), nozzleDown().coeffs());
    }
}

TEST(HeightFieldLift, LaysThePartsVolume) {
  const Mesh part = roof();
  EXPECT_NEAR(totals(planned(part, solid())).deposited_mm3 / volume(part), 1.0, 0.02);
}

TEST(HeightFieldLift, NeverLaysBelowTheBedNorAboveThePart) {
  const Box3 box = depositionBox(planned(roof(), solid()));
  EXPECT_GT(box.low.z(), 0.0);
  EXPECT_LE(box.high.z(), roofAt(16.0) + 1e-4);
}

}  // namespace
}  // namespace lamina
