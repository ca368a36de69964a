// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/raster_direction.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/geometry/polygon/convex_hull.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::reversed;

constexpr double kDegree = M_PI / 180.0;

Polygon turned(Polygon polygon, double angle_rad) {
  const double cos = std::cos(angle_rad);
  const double sin = std::sin(angle_rad);
  for (Point2& p : polygon) p = {cos * p.x() - sin * p.y(), sin * p.x() + cos * p.y()};
  return polygon;
}

InfillRequest rasterDirectionSolid(double pitch, RasterDirection direction) {
  InfillRequest request;
  request.pitch_mm = request.spacing_mm = pitch;
  request.settings.raster.direction = direction;
  return request;
}

std::vector<FillPath> filled(const std::string& strategy, const Regions& area, const InfillRequest& request) {
  return infillStrategy(strategy).fill(area, request);
}

/// Passes of the raster: stretches of at least 2 mm to and fro along a direction.
int passesAlong(const std::vector<FillPath>& runs, double angle_rad) {
  constexpr double kLeast = 2.0;
  const Point2 along(std::cos(angle_rad), std::sin(angle_rad));
  int passes = 0;
  for (const FillPath& run : runs) {
    if (run.role != PathRole::Infill) continue;
    double turn = run.points.front().dot(along);
    double sense = 0.0;
    for (const Point2& point : run.points) {
      const double at = point.dot(along);
      if (sense * (at - turn) > 0.0) turn = at;
      if (std::abs(at - turn) < kLeast) continue;
      sense = at > turn ? 1.0 : -1.0;
      turn = at;
      ++passes;
    }
  }
  return passes;
}

double travelTo(const std::vector<FillPath>& runs, const Point2& start) {
  double sum = 0.0;
  Point2 from = start;
  for (const FillPath& run : runs) {
    sum += (run.points.front() - from).norm();
    from = lastPoint(run);
  }
  return sum;
}

TEST(RasterDirection, OfFewestTurnsIsThatOfTheLongSide) {
  EXPECT_NEAR(angleOfFewestTurns({{turned(rectangle(0, 0, 40, 8), 30 * kDegree), {}}}, 0.0), 30 * kDegree,
              1e-12);
  EXPECT_NEAR(angleOfFewestTurns({{turned(rectangle(0, 0, 8, 40), 30 * kDegree), {}}}, 0.0), 120 * kDegree,
              1e-12);
}

TEST(RasterDirection, AcrossAConvexRegionIsItsWidth) {
  const Regions square = {{rectangle(0, 0, 10, 10), {}}};
  EXPECT_NEAR(extentAcross(square, 0.0), 10.0, 1e-12);
  EXPECT_NEAR(extentAcross(square, M_PI / 4), 10.0 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(extentAcross({{circle({3, 4}, 5, 720), {}}}, 1.234), 10.0, 1e-3);
}

TEST(RasterDirection, AcrossARegionWithAHoleCountsBothSidesOfTheHole) {
  const Regions plate = {{rectangle(0, 0, 20, 10), {reversed(rectangle(8, 2, 12, 8))}}};
  EXPECT_NEAR(extentAcross(plate, 0.0), 16.0, 1e-12);
  EXPECT_NEAR(extentAcross(plate, M_PI / 2), 24.0, 1e-12);
}

TEST(RasterDirection, StaysAsGivenWhereNoOtherIsBetter) {
  EXPECT_EQ(angleOfFewestTurns({{rectangle(0, 0, 10, 10), {}}}, M_PI / 2), M_PI / 2);
  EXPECT_EQ(angleOfFewestTurns({}, 0.7), 0.7);
}

TEST(RasterDirection, OfFewestTurnsIsNoWorseThanAnySampledOne) {
  EXPECT_TRUE(rc::check("random regions", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions regions = unite(
        {test::star(random, {0, 0}, 5.0, 12.0, 24), reversed(test::star(random, {0, 0}, 1.0, 3.0, 12))});
    const double least = extentAcross(regions, angleOfFewestTurns(regions, 0.3));
    for (int i = 0; i < 180; ++i) RC_ASSERT(least <= extentAcross(regions, i * kDegree) * (1.0 + 1e-9));
  }));
}

class StrategyInBestDirection : public testing::TestWithParam<std::string> {};

TEST_P(StrategyInBestDirection, RunsAlongTheLongSideOfATurnedRectangle) {
  const Regions area = {{turned(rectangle(0, 0, 40, 8), 30 * kDegree), {}}};
  for (const RasterDirection direction : {RasterDirection::FewestTurns, RasterDirection::LeastTravel}) {
    const std::vector<FillPath> runs = filled(GetParam(), area, rasterDirectionSolid(1.0, direction));
    EXPECT_EQ(passesAlong(runs, 30 * kDegree), GetParam() == "hybrid" ? 6 : 8);
  }
}

TEST_P(StrategyInBestDirection, TakesNoMorePassesThroughAConvexRegionThanAtSampledAngles) {
  EXPECT_TRUE(rc::check("random convex regions", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions area = {{convexHull(test::star(random, {0, 0}, 9.0, 15.0, 12)), {}}};
    InfillRequest request = rasterDirectionSolid(1.0, RasterDirection::FewestTurns);
    const int fewest = passesAlong(filled(GetParam(), area, request), angleOfFewestTurns(area, 0.0));
    request.settings.raster.direction = RasterDirection::Given;
    for (int i = 0; i < 12; ++i) {
      request.angle_rad = 15.0 * i * kDegree;
      // Outermost passes may be shorter than those that are counted.
      RC_ASSERT(fewest <= passesAlong(filled(GetParam(), area, request), request.angle_rad) + 2);
    }
  }));
}

TEST_P(StrategyInBestDirection, TravelsNoFartherThanAtTheSampledAngles) {
  const Regions comb = {{{{0, 0},
                          {40, 0},
                          {40, 20},
                          {30, 20},
                          {30, 6},
                          {25, 6},
                          {25, 20},
                          {15, 20},
                          {15, 6},
                          {10, 6},
                          {10, 20},
                          {0, 20}},
                         {}}};
  InfillRequest request = rasterDirectionSolid(1.0, RasterDirection::LeastTravel);
  request.settings.raster.longest_connection_mm = 0.0;
  const double least = travelTo(filled(GetParam(), comb, request), request.start);
  request.settings.raster.direction = RasterDirection::Given;
  for (int i = 0; i < 12; ++i) {
    request.angle_rad = M_PI * i / 12;
    EXPECT_LE(least, travelTo(filled(GetParam(), comb, request), request.start) + request.spacing_mm)
        << 15 * i << " degrees";
  }
}

INSTANTIATE_TEST_SUITE_P(Infill, StrategyInBestDirection, testing::Values("zigzag", "hybrid"),
                         [](const testing::TestParamInfo<std::string>& name) { return name.param; });

}  // namespace
}  // namespace lamina
