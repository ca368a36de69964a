// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/curve_ends.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/lofted_solid.hpp"

namespace lamina {
namespace {

/// Along x, as high as given at 0, 1, 2 ... mm.
AdaptedCurve ofHeights(const std::vector<double>& heights) {
  AdaptedCurve curve;
  curve.is_closed = false;
  for (const double height : heights) {
    curve.points.emplace_back(static_cast<double>(curve.points.size()), 0.0, height);
    curve.axis.push_back(Point3::UnitZ());
    curve.height_mm.push_back(height);
  }
  return curve;
}

TEST(CurveEnds, AreCutWhereTheCurveIsHighEnough) {
  const AdaptedCurve cut = withoutThinEnds(ofHeights({0.0, 0.1, 0.4, 0.4, 0.0}), 0.2);
  ASSERT_EQ(cut.points.size(), 4U);
  EXPECT_NEAR(cut.points.front().x(), 1.0 + 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(cut.points.back().x(), 3.5, 1e-12);
  EXPECT_NEAR(cut.height_mm.front(), 0.2, 1e-12);
  EXPECT_NEAR(cut.height_mm.back(), 0.2, 1e-12);
}

TEST(CurveEnds, HighEnoughStay) {
  const AdaptedCurve curve = ofHeights({0.2, 0.4, 0.3});
  EXPECT_EQ(withoutThinEnds(curve, 0.2).points, curve.points);
}

TEST(CurveEnds, OfACurveTooLowLeaveNothing) {
  EXPECT_TRUE(withoutThinEnds(ofHeights({0.0, 0.1, 0.1}), 0.2).points.empty());
}

TEST(CurveEnds, OfCompletingLayersAreAQuarterOfALayerHigh) {
  const Mesh mesh = test::loftedSolid(
      {0.0, 12.0}, 120, [](double phi, double z) { return 20.0 + z * (1.0 + std::cos(phi)) / 2.0; });
  SlicingSettings slicing;
  slicing.layer_height_mm = 0.8;
  slicing.first_layer_height_mm = 0.8;
  NoProgress progress;
  const AdaptedLayers layers = adaptedLayers(mesh, slicing, {}, progress);
  ASSERT_GT(layers.completing, 0U);
  for (const AdaptedLayer& layer : layers.layers)
    for (const AdaptedCurve& curve : layer.curves)
      for (const double height : curve.height_mm) EXPECT_GE(height, 0.25 * 0.8 - 1e-12);
}

}  // namespace
}  // namespace lamina
