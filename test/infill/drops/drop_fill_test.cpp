// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/drops/drop_fill.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/fill_requests.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::requestOf;
using test::reversed;

std::vector<Point2> dropsOf(const std::string& strategy, const Regions& regions, double diameter,
                            double angle = 0.0) {
  std::vector<Point2> drops;
  for (const FillPath& path : infillStrategy(strategy).fill(regions, requestOf(diameter, angle)))
    drops.insert(drops.end(), path.points.begin(), path.points.end());
  return drops;
}

double leastDistance(const std::vector<Point2>& drops) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < drops.size(); ++i)
    for (std::size_t j = i + 1; j < drops.size(); ++j) least = std::min(least, (drops[i] - drops[j]).norm());
  return least;
}

TEST(DropsAlong, AnOutlineLieAtItsCornersAndEvenlyBetweenThem) {
  const Polyline drops = dropsAlong(rectangle(0, 0, 3.9, 2), 1.0, 1.0);
  ASSERT_EQ(drops.size(), 10U) << "3 + 2 + 3 + 2";
  EXPECT_NEAR((drops[1] - drops[0]).norm(), 1.3, 1e-9);
  EXPECT_NEAR((drops[4] - drops[3]).norm(), 1.0, 1e-9);
}

TEST(DropsAlong, AnOutlineStandNearerWhereTheGapWouldBeWide) {
  EXPECT_EQ(dropsAlong(rectangle(0, 0, 1.7, 2), 1.0, 0.8).size(), 2U * (2U + 2U)) << "0.85 apart, not 1.7";
  EXPECT_EQ(dropsAlong(rectangle(0, 0, 1.5, 2), 1.0, 0.8).size(), 2U * (1U + 2U)) << "0.75 would be too near";
  EXPECT_EQ(dropsAlong(rectangle(0, 0, 2.4, 2), 1.0, 0.8).size(), 2U * (2U + 2U)) << "1.2 is no wide gap";
}

TEST(DropsAlong, ACircleGoRoundItEvenly) {
  const Polyline drops = dropsAlong(circle({0, 0}, 5, 200), 1.0, 0.8);
  EXPECT_EQ(drops.size(), 31U) << "2 pi 5 = 31.4";
}

TEST(DropsAlong, AnOutlineShorterThanThePitchAreOne) {
  EXPECT_EQ(dropsAlong(rectangle(0, 0, 0.2, 0.2), 1.0, 0.8), (Polyline{{0.1, 0.1}}));
  EXPECT_TRUE(dropsAlong({}, 1.0, 0.8).empty());
}

TEST(DropsContour, OfASquareAreAsManyAsItsSidesHaveRoomFor) {
  // Loops half a drop inside and a drop further each; the side's length rounded down per side.
  for (const double side : {10.0, 10.3, 10.6, 10.8})
    EXPECT_EQ(dropsOf("drops_contour", {{rectangle(0, 0, side, side), {}}}, 1.0).size(), 100U) << side;
  EXPECT_EQ(dropsOf("drops_contour", {{rectangle(0, 0, 12.6, 12.6), {}}}, 1.0).size(), 144U);
}

TEST(DropsDense, LieOnAHexagonalLatticeInsideTheContour) {
  const std::vector<FillPath> paths =
      infillStrategy("drops_dense").fill({{rectangle(-10, -10, 10, 10), {}}}, requestOf(1.0, 0.3));
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_EQ(paths[0].role, PathRole::OuterWall);
  EXPECT_EQ(paths[1].role, PathRole::Infill);
  EXPECT_NEAR(leastDistance(paths[1].points), 1.0, 1e-9);
  // Each drop of a hexagonal lattice takes sqrt(3) / 2; centres lie within 17 mm by 17 mm.
  EXPECT_NEAR(static_cast<double>(paths[1].points.size()), 17.0 * 17.0 / (0.5 * std::sqrt(3.0)), 20.0);
}

TEST(DropsRaster, LieOnStraightLinesInsideTheContour) {
  const std::vector<FillPath> paths =
      infillStrategy("drops_raster").fill({{rectangle(0.5, 0.5, 10.5, 10.5), {}}}, requestOf(1.0, 0.0));
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_EQ(paths[0].points.size(), 36U);
  // Centres from 2 to 9: 7 pitches; the line at 9 is the top of the region and belongs to none.
  EXPECT_EQ(paths[1].points.size(), 7U * 8U);
  EXPECT_NEAR(leastDistance(paths[1].points), 1.0, 1e-9);
}

TEST(DropStrategies, LayNoTwoDropsNearerThanTheOverlapAllows) {
  EXPECT_TRUE(rc::check("random regions with holes and islands", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions regions =
        unite({test::star(random, {0, 0}, 4.0, 9.0, 20), reversed(test::star(random, {0, 0}, 1.0, 3.0, 9)),
               test::star(random, {20, 3}, 0.5, 4.0, 9)});
    const double diameter = random.uniform(0.4, 1.5);
    for (const char* strategy : {"drops_raster", "drops_contour", "drops_dense"})
      RC_ASSERT(leastDistance(dropsOf(strategy, regions, diameter, random.uniform(-3, 3))) >=
                0.8 * diameter * (1.0 - 1e-5));
  }));
}

TEST(DropStrategies, KeepHalfADropFromTheBorder) {
  const Regions ring = {{circle({0, 0}, 12, 90), {reversed(circle({0, 0}, 5, 60))}}};
  for (const char* strategy : {"drops_raster", "drops_contour", "drops_dense"})
    for (const Point2& drop : dropsOf(strategy, ring, 0.7))
      EXPECT_GT(test::distanceToOutline(outlines(ring), drop), 0.35 - 1e-4) << strategy;
}

TEST(DropStrategies, LayASingleRowIntoAWallNotTwoDropsWide) {
  for (const Point2& drop : dropsOf("drops_contour", {{rectangle(0, 0, 20, 1.2), {}}}, 1.0))
    EXPECT_NEAR(drop.y(), 0.6, 0.1 + 1e-9);
}

TEST(DropCount, IsAtMostFiveMillionInALayer) {
  DropSettings settings;
  settings.pitch_mm = 0.1;
  const Regions room = {{{{0, 0}, {200, 0}, {200, 200}, {0, 200}}, {}}};
  EXPECT_NO_THROW(requireFewDrops(room, settings)) << "4 million";
  settings.pitch_mm = 0.08;
  EXPECT_THROW(requireFewDrops(room, settings), InvalidInput) << "6.25 million";
}

}  // namespace
}  // namespace lamina
