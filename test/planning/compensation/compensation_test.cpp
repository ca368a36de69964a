// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/compensation/compensation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;

/// A square of 20 mm round a hole of that diameter.
Regions holedSquare(double hole_mm) {
  return {{rectangle(0, 0, 20, 20), {test::reversed(circle({10, 10}, 0.5 * hole_mm, 720))}}};
}

double widthAt(const Regions& regions, const Point2& point, double tolerance = 1e-3) {
  double half = 0.0;
  while (contains(outlines(regions), point + Point2(half, 0)) && half < 100.0) half += tolerance;
  double other = 0.0;
  while (contains(outlines(regions), point - Point2(other, 0)) && other < 100.0) other += tolerance;
  return half + other;
}

TEST(Compensation, ChangesNothingWhereNothingIsSet) {
  std::vector<Layer> layers =
      test::layersOf(3, [](int) { return std::vector<Polygon>{rectangle(0, 0, 20, 20)}; });
  NoProgress nobody;
  compensate(layers, {}, {}, 0.4, nobody);
  for (const Layer& layer : layers) EXPECT_EQ(layer.section.contours[0], rectangle(0, 0, 20, 20));
}

TEST(Compensation, TakesOffOutlinesAndHoles) {
  CompensationSettings settings;
  settings.outline_mm = 0.1;
  settings.holes_mm = 0.1;
  const Regions regions = compensated(holedSquare(5.0), settings);
  ASSERT_EQ(regions.size(), 1U);
  const Box2 box = boundingBox({regions[0].outer});
  EXPECT_NEAR(box.size().x(), 19.8, 1e-4);
  EXPECT_NEAR(box.size().y(), 19.8, 1e-4);
  ASSERT_EQ(regions[0].holes.size(), 1U);
  EXPECT_NEAR(boundingBox({regions[0].holes[0]}).size().x(), 5.2, 1e-3);
  EXPECT_NEAR(area(regions), 19.8 * 19.8 - M_PI * 2.6 * 2.6, 0.01);
}

TEST(Compensation, AddsByNegativeValues) {
  CompensationSettings settings;
  settings.outline_mm = -0.1;
  settings.holes_mm = -0.1;
  const Regions regions = compensated(holedSquare(5.0), settings);
  EXPECT_NEAR(area(regions), 20.2 * 20.2 - M_PI * 2.4 * 2.4, 0.01);
}

TEST(Compensation, LeavesWideHolesAlone) {
  CompensationSettings settings;
  settings.holes_mm = 0.1;
  settings.least_hole_mm = 6.0;
  EXPECT_NEAR(area(compensated(holedSquare(5.0), settings)), 400.0 - M_PI * 2.6 * 2.6, 0.01);
  EXPECT_NEAR(area(compensated(holedSquare(8.0), settings)), 400.0 - M_PI * 16.0, 0.01);
}

TEST(Compensation, KeepsAnIslandWithinAHole) {
  CompensationSettings settings;
  settings.holes_mm = 0.5;
  Regions regions = holedSquare(10.0);
  regions.push_back({circle({10, 10}, 4.8, 720), {}});
  const Regions result = compensated(regions, settings);
  EXPECT_EQ(result.size(), 2U);
  EXPECT_NEAR(area(result), 400.0 - M_PI * (5.5 * 5.5 - 4.8 * 4.8), 0.02);
}

TEST(InsetOnBed, ShrinksTheFirstLayerAlone) {
  FirstLayerSettings first;
  first.inset_mm = 0.2;
  std::vector<Layer> layers =
      test::layersOf(3, [](int) { return std::vector<Polygon>{rectangle(0, 0, 20, 20)}; });
  NoProgress nobody;
  compensate(layers, {}, first, 0.4, nobody);
  EXPECT_NEAR(boundingBox(layers[0].section.contours).size().x(), 19.6, 1e-4);
  EXPECT_NEAR(signedArea(layers[0].section.contours), 19.6 * 19.6, 1e-3);
  for (const int i : {1, 2}) EXPECT_EQ(layers[i].section.contours[0], rectangle(0, 0, 20, 20));
}

TEST(InsetOnBed, TapersOverItsLayers) {
  FirstLayerSettings first;
  first.inset_mm = 0.3;
  first.inset_layers = 3;
  for (const auto& [layer, inset] :
       {std::pair(0, 0.3), std::pair(1, 0.2), std::pair(2, 0.1), std::pair(3, 0.0)})
    EXPECT_NEAR(insetOf(static_cast<std::size_t>(layer), first), inset, 1e-12) << layer;
}

TEST(InsetOnBed, LeavesANarrowFinAsItIsAndJoined) {
  // A fin of 0.5 mm on a block of 10 mm: narrower than a bead and two insets, 0.8 mm.
  const Regions part = unite({rectangle(0, 0, 10, 10), rectangle(4.75, 9, 5.25, 18)});
  const Regions inset = insetOnBed(part, 0.2, 0.4);
  ASSERT_EQ(inset.size(), 1U) << "the fin is joined to the block";
  EXPECT_NEAR(widthAt(inset, {5.0, 14.0}), 0.5, 4e-3);
  EXPECT_NEAR(boundingBox({inset[0].outer}).high.y(), 18.0, 1e-4);
  EXPECT_NEAR(widthAt(inset, {5.0, 5.0}), 9.6, 4e-3);
  // Beside the fin's root nothing more than an inset on either side keeps its place.
  EXPECT_NEAR(area(inset), 9.6 * 9.6 + 0.5 * 8.2 + 2 * 0.2 * 0.21, 0.05);
}

TEST(InsetOnBed, LeavesAPartThatIsNarrowAllOver) {
  const Regions fin = {{rectangle(0, 0, 0.5, 10), {}}};
  EXPECT_NEAR(area(insetOnBed(fin, 0.2, 0.4)), 5.0, 1e-3);
}

TEST(Shrinkage, MakesUpForAShare) {
  CompensationSettings settings;
  settings.shrink_xy = 0.005;
  settings.shrink_z = 0.01;
  const Point3 factors = shrinkageFactors(settings);
  EXPECT_NEAR(100.0 * factors.x(), 100.5025, 1e-4);
  EXPECT_NEAR(100.0 * factors.y(), 100.5025, 1e-4);
  EXPECT_NEAR(100.0 * factors.z(), 101.0101, 1e-4);
}

}  // namespace
}  // namespace lamina
