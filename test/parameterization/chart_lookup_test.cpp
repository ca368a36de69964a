// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/chart_lookup.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "support/charts.hpp"

namespace lamina {
namespace {

using test::halfCylinder;
using test::levelChart;
using test::polarCap;

/// A point of a triangle in the parameter plane by weights.
Point2 planAt(const LayerChart& chart, const ChartPlace& place) {
  const Triangle& triangle = chart.surface.middle.triangles[place.in.triangle];
  return place.weights[0] * chart.parameterization[triangle[0]] +
         place.weights[1] * chart.parameterization[triangle[1]] +
         place.weights[2] * chart.parameterization[triangle[2]];
}

ChartPlace randomPlace(const LayerChart& chart, Random& random) {
  ChartPlace place;
  place.in.triangle = static_cast<std::uint32_t>(
      random.below(static_cast<std::uint32_t>(chart.surface.middle.triangles.size())));
  const double u = std::sqrt(random.uniform(0.0, 1.0));
  const double v = random.uniform(0.0, 1.0);
  place.weights = {1.0 - u, u * (1.0 - v), u * v};
  return place;
}

TEST(ChartLookup, UnflattensWhatWasFlattenedToWhereItWas) {
  for (const LayerChart& chart : {halfCylinder(10.0, 20.0, 64), polarCap(10.0, 0.5 * M_PI, 12, 40)}) {
    const std::vector<LayerChart> charts = {chart};
    const ChartLookup lookup(charts);
    const Mesh& mesh = chart.surface.middle;
    EXPECT_TRUE(rc::check([&] {
      Random random(*rc::gen::arbitrary<std::uint64_t>());
      const ChartPlace place = randomPlace(chart, random);
      const Triangle& triangle = mesh.triangles[place.in.triangle];
      Point3 middle = Point3::Zero();
      for (int i = 0; i < 3; ++i)
        middle += place.weights[i] * mesh.vertices[triangle[static_cast<std::size_t>(i)]];
      const SurfacePoint found = lookup.lifted(lookup.at(planAt(chart, place)));
      RC_ASSERT((found.middle - middle).norm() <= 1e-9);
      RC_ASSERT(std::abs(found.normal.norm() - 1.0) <= 1e-12);
    }));
  }
}

TEST(ChartLookup, BringsEachVertexBackWithItsQuantities) {
  const std::vector<LayerChart> charts = {halfCylinder(10.0, 20.0, 64)};
  const LayerSurface& surface = charts[0].surface;
  const ChartLookup lookup(charts);
  for (std::size_t i = 0; i < surface.tip.size(); ++i) {
    const SurfacePoint found = lookup.lifted(lookup.at(charts[0].parameterization[i]));
    EXPECT_NEAR((found.middle - surface.middle.vertices[i]).norm(), 0.0, 1e-9);
    EXPECT_NEAR((found.tip - surface.tip[i]).norm(), 0.0, 1e-9);
    EXPECT_NEAR((found.normal - surface.normal[i]).norm(), 0.0, 1e-9);
    EXPECT_NEAR(found.height_mm, surface.height_mm[i], 1e-9);
  }
}

TEST(ChartLookup, DrawsPointsJustOutsideToTheBorderAndRefusesOthers) {
  const std::vector<LayerChart> charts = {levelChart(10.0, 5)};
  const ChartLookup lookup(charts);
  EXPECT_NEAR((lookup.lifted(lookup.at({-0.009, 3.0})).middle - Point3(0, 3, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((lookup.lifted(lookup.at({10.0 + 0.009, 10.0})).middle - Point3(10, 10, 0)).norm(), 0.0, 1e-12);
  EXPECT_FALSE(lookup.find({-0.051, 3.0}));
  EXPECT_FALSE(lookup.find({1e6, 3.0}));
  EXPECT_THROW(lookup.at({-0.051, 3.0}), InvalidInput);
}

TEST(ChartLookup, CutsALineAtTheSidesOfTriangles) {
  const std::vector<LayerChart> charts = {levelChart(10.0, 5)};
  const auto stretches = ChartLookup(charts).stretches({1.0, 0.5}, {9.0, 0.5});
  ASSERT_TRUE(stretches);
  // Cells of 2 mm with a diagonal each: sides at x = 2, 4, 6, 8, diagonals half a millimetre behind.
  const std::vector<double> expected = {2.0, 2.5, 4.0, 4.5, 6.0, 6.5, 8.0, 8.5, 9.0};
  ASSERT_EQ(stretches->size(), expected.size());
  double from = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR((*stretches)[i].from, from, 1e-9);
    EXPECT_NEAR((*stretches)[i].to, (expected[i] - 1.0) / 8.0, 1e-9);
    from = (*stretches)[i].to;
  }
}

TEST(ChartLookup, FollowsLinesAlongSidesAndBorders) {
  const std::vector<LayerChart> charts = {levelChart(10.0, 5)};
  const ChartLookup lookup(charts);
  for (const double y : {0.0, 4.0, 10.0, -0.5e-6}) {
    const auto stretches = lookup.stretches({0.0, y}, {10.0, y});
    ASSERT_TRUE(stretches) << y;
    EXPECT_EQ(stretches->front().from, 0.0);
    EXPECT_EQ(stretches->back().to, 1.0);
  }
  const auto diagonal = lookup.stretches({0.0, 0.0}, {10.0, 10.0});
  ASSERT_TRUE(diagonal);
  EXPECT_EQ(diagonal->size(), 5U);
}

/// Charts of one height that touch are one plane: a run may go over from one to the other.
TEST(ChartLookup, FollowsALineOverLevelChartsThatTouch) {
  const std::vector<LayerChart> charts = {levelChart(10.0, 5), test::moved(levelChart(10.0, 5), {10.0, 0.0})};
  const auto stretches = ChartLookup(charts).stretches({1.0, 3.0}, {19.0, 3.0});
  ASSERT_TRUE(stretches);
  EXPECT_EQ(stretches->front().in.chart, 0U);
  EXPECT_EQ(stretches->back().in.chart, 1U);
  EXPECT_EQ(stretches->back().to, 1.0);
  for (std::size_t i = 1; i < stretches->size(); ++i) EXPECT_EQ((*stretches)[i].from, (*stretches)[i - 1].to);
}

TEST(ChartLookup, CoversAnyLineInsideByStretchesThatItsTrianglesHold) {
  const std::vector<LayerChart> charts = {polarCap(10.0, 0.5 * M_PI, 12, 40)};
  const ChartLookup lookup(charts);
  EXPECT_TRUE(rc::check([&] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Point2 from = planAt(charts[0], randomPlace(charts[0], random));
    const Point2 to = planAt(charts[0], randomPlace(charts[0], random));
    const auto stretches = lookup.stretches(from, to);
    RC_ASSERT(stretches.has_value());
    double reached = 0.0;
    for (const ChartStretch& stretch : *stretches) {
      RC_ASSERT(stretch.from == reached);
      reached = stretch.to;
      const Point2 middle = from + 0.5 * (stretch.from + stretch.to) * (to - from);
      RC_ASSERT((planAt(charts[0], lookup.within(stretch.in, middle)) - middle).norm() <= 1e-8);
    }
    RC_ASSERT(reached == 1.0);
  }));
}

TEST(ChartLookup, DoesNotFollowALineThatLeavesItsChart) {
  const std::vector<LayerChart> charts = {levelChart(10.0, 5), test::moved(levelChart(10.0, 5), {12.0, 0.0})};
  const ChartLookup lookup(charts);
  EXPECT_FALSE(lookup.stretches({5.0, 5.0}, {15.0, 5.0}));
  EXPECT_TRUE(lookup.stretches({13.0, 5.0}, {15.0, 5.0}));
  EXPECT_EQ(lookup.at({15.0, 5.0}).in.chart, 1U);
}

TEST(ChartLookup, ReportsAreasInSpaceByThoseOfTheParameterPlane) {
  std::vector<LayerChart> charts = {levelChart(10.0, 1)};
  for (Point3& vertex : charts[0].surface.middle.vertices) vertex.z() = vertex.x();
  EXPECT_NEAR(ChartLookup(charts).areaRatio({0, 0}), std::sqrt(2.0), 1e-12);
}

TEST(ChartLookup, RefusesChartsThatAreNotWhole) {
  EXPECT_THROW(ChartLookup(std::vector<LayerChart>()), InvalidInput);
  std::vector<LayerChart> charts = {levelChart(10.0, 1)};
  charts[0].parameterization.pop_back();
  EXPECT_THROW(ChartLookup{charts}, InvalidInput);
}

}  // namespace
}  // namespace lamina
