// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/curve_untangling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "lamina/geometry/parts/parts.hpp"
#include "lamina/slicing/adapted/adapted_surfaces.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "slicing/adapted/plan_crossings.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

AdaptedCurve through(const std::vector<Point3>& points, bool is_closed) {
  return {is_closed, points, std::vector<Point3>(points.size(), Point3::UnitZ()),
          std::vector<double>(points.size(), 0.2)};
}

/// A triangle whose last corner is a loop of one by one: it crosses itself at (9, 1).
AdaptedCurve looped() {
  return through({{0, 0, 0}, {8, 0, 0}, {10, 2, 1}, {10, 0, 1}, {8, 2, 0}, {0, 2, 0}}, true);
}

TEST(CurveUntangling, APointTakesThePlaceOfASmallLoop) {
  const AdaptedCurve curve = withoutSmallLoops(looped(), 6.0);
  ASSERT_EQ(curve.points.size(), 5U);
  // Halfway up both of the segments that cross.
  EXPECT_LE((curve.points[2] - Point3(9, 1, 0.5)).norm(), 1e-12);
  EXPECT_TRUE(planCrossings({curve}).empty());
}

TEST(CurveUntangling, ALoopMayLieAcrossTheFirstPoint) {
  AdaptedCurve curve = looped();
  std::rotate(curve.points.begin(), curve.points.begin() + 3, curve.points.end());
  EXPECT_EQ(withoutSmallLoops(curve, 6.0).points.size(), 5U);
}

TEST(CurveUntangling, LongLoopsStayAndAreRefusedWithThePlace) {
  const AdaptedCurve curve = withoutSmallLoops(looped(), 4.0);
  EXPECT_EQ(curve.points.size(), 6U);
  const Mesh box = test::boxBetween({9, 0, 0}, {10, 1, 1});
  try {
    requireNoCrossing({curve}, 7, box);
    FAIL() << "no refusal";
  } catch (const Unsliceable& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("layer 7"), std::string::npos) << message;
    EXPECT_NE(message.find("(9.00, 1.00, 0.50) mm"), std::string::npos) << message;
    EXPECT_FALSE(error.region().triangles.empty());
  }
}

TEST(CurveUntangling, OpenCurvesEndWhereTheyDo) {
  AdaptedCurve curve = looped();
  curve.is_closed = false;
  const AdaptedCurve untangled = withoutSmallLoops(curve, 6.0);
  EXPECT_EQ(untangled.points.front(), curve.points.front());
  EXPECT_EQ(untangled.points.back(), curve.points.back());
  EXPECT_EQ(untangled.points.size(), 5U);
}

TEST(PlanCrossings, AreFoundBetweenCurvesWhateverTheirHeights) {
  const AdaptedCurve one = through({{0, 0, 0}, {4, 4, 0}}, false);
  const AdaptedCurve other = through({{0, 4, 9}, {4, 0, 9}}, false);
  const std::vector<PlanCrossing> crossings = planCrossings({one, other});
  ASSERT_EQ(crossings.size(), 1U);
  EXPECT_EQ(crossings[0].first.curve, 0U);
  EXPECT_EQ(crossings[0].second.curve, 1U);
  EXPECT_NEAR(crossings[0].second.fraction, 0.5, 1e-12);
}

TEST(PlanCrossings, TouchingIsNone) {
  const AdaptedCurve square = through({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, true);
  EXPECT_TRUE(planCrossings({square, through({{2, 0, 0}, {2, 4, 0}}, false)}).empty());
}

TEST(CurveUntangling, ABladeThatLeansOverItsSharpEdgeCanBeFilled) {
  const Mesh blade = makePart("blade", {{"lean_deg", "30"}, {"height_mm", "10"}});
  SlicingSettings slicing;
  const AdaptedSettings settings;
  NoProgress progress;
  const AdaptedLayers layers = adaptedLayers(blade, slicing, settings, progress);
  for (const AdaptedLayer& layer : layers.layers) {
    EXPECT_TRUE(planCrossings(layer.curves).empty());
    EXPECT_TRUE(planCrossings(layer.outlines).empty());
  }
  const double bottom_mm = boundingBox(blade).low.z();
  EXPECT_EQ(adaptedSurfaces(layers, bottom_mm, 2.0, progress).size(), layers.layers.size());
}

}  // namespace
}  // namespace lamina
