// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/polygon/offset.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/error.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::reversed;

/// Area of an outline of 50 mm perimeter moved by half a grid unit, and then some [mm²].
constexpr double kAreaTolerance = 1e-3;

TEST(Unite, JoinsOverlappingSquares) {
  const Regions regions = unite({rectangle(0, 0, 10, 10), rectangle(5, 5, 15, 15)});
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_NEAR(area(regions), 175.0, kAreaTolerance);
}

TEST(Unite, KeepsAnIslandInsideAHoleAsItsOwnRegion) {
  const Regions regions =
      unite({rectangle(0, 0, 30, 30), reversed(rectangle(5, 5, 25, 25)), rectangle(10, 10, 20, 20)});
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_NEAR(area(regions), 900 - 400 + 100, kAreaTolerance);
  EXPECT_EQ(regions[0].holes.size() + regions[1].holes.size(), 1U);
}

TEST(Unite, WindsOutlinesCounterClockwiseAndHolesClockwise) {
  const Regions regions = unite({rectangle(0, 0, 30, 30), reversed(rectangle(5, 5, 25, 25))});
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_GT(signedArea(regions[0].outer), 0.0);
  ASSERT_EQ(regions[0].holes.size(), 1U);
  EXPECT_LT(signedArea(regions[0].holes[0]), 0.0);
}

TEST(Unite, OfNothingIsNothing) {
  EXPECT_TRUE(unite({}).empty());
  EXPECT_TRUE(unite({{}, {{1, 1}}, {{0, 0}, {1, 1}}}).empty());
}

TEST(Unite, RefusesPointsBeyondTenMetres) {
  EXPECT_THROW(unite({rectangle(0, 0, 10001, 1)}), InvalidInput);
  EXPECT_THROW(unite({{{0, 0}, {std::nan(""), 0}, {1, 1}}}), InvalidInput);
}

TEST(Offset, ShrinksASquareToASquare) {
  const Regions shrunk = offset({{rectangle(0, 0, 20, 20), {}}}, -0.2);
  ASSERT_EQ(shrunk.size(), 1U);
  EXPECT_EQ(shrunk[0].outer.size(), 4U);
  EXPECT_NEAR(area(shrunk), 19.6 * 19.6, kAreaTolerance);
}

TEST(Offset, GrowsAHoleWhenShrinking) {
  const Regions shrunk = offset({{rectangle(0, 0, 20, 20), {reversed(rectangle(5, 5, 15, 15))}}}, -1.0);
  EXPECT_NEAR(area(shrunk), 18.0 * 18.0 - 12.0 * 12.0, kAreaTolerance);
}

TEST(Offset, SplitsADumbbellAtItsNeck) {
  const Polygon dumbbell = {{0, 0},   {10, 0},  {10, 4}, {20, 4}, {20, 0},  {30, 0},
                            {30, 10}, {20, 10}, {20, 6}, {10, 6}, {10, 10}, {0, 10}};
  EXPECT_EQ(offset({{dumbbell, {}}}, -0.5).size(), 1U);
  EXPECT_EQ(offset({{dumbbell, {}}}, -1.5).size(), 2U);
  EXPECT_TRUE(offset({{dumbbell, {}}}, -6.0).empty());
}

TEST(Offset, WithRoundJoinsGrowsASquareByQuarterDiscs) {
  const Regions grown = offset({{rectangle(0, 0, 20, 20), {}}}, 5.0, Join::Round);
  EXPECT_NEAR(area(grown), 400 + 4 * 20 * 5 + M_PI * 25, 0.3);
}

TEST(Offset, WithMitresGrowsASquareToASquare) {
  EXPECT_NEAR(area(offset({{rectangle(0, 0, 20, 20), {}}}, 5.0)), 900.0, kAreaTolerance);
}

TEST(Difference, CutsAHole) {
  const Regions cut = difference({{rectangle(0, 0, 10, 10), {}}}, {{rectangle(2, 2, 4, 4), {}}});
  ASSERT_EQ(cut.size(), 1U);
  EXPECT_EQ(cut[0].holes.size(), 1U);
  EXPECT_NEAR(area(cut), 96.0, kAreaTolerance);
}

TEST(Intersection, IsWhatBothCover) {
  EXPECT_NEAR(area(intersection({{rectangle(0, 0, 10, 10), {}}}, {{rectangle(6, 8, 20, 20), {}}})), 8.0,
              kAreaTolerance);
  EXPECT_TRUE(intersection({{rectangle(0, 0, 10, 10), {}}}, {{rectangle(10, 0, 20, 10), {}}}).empty());
}

TEST(Offset, ShrinkingKeepsItsDistanceFromTheOutline) {
  EXPECT_TRUE(rc::check("every point of a shrunk star is at least that far inside", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions regions = unite({test::star(random, {3, -2}, 4.0, 15.0, 40)});
    const double distance = random.uniform(0.05, 1.5);
    const std::vector<Polygon> borders = outlines(regions);
    for (const Polygon& loop : outlines(offset(regions, -distance)))
      for (const Point2& point : loop) {
        RC_ASSERT(contains(borders, point));
        RC_ASSERT(test::distanceToOutline(borders, point) > distance - 3e-5);
      }
  }));
}

TEST(Offset, ShrinkingLeavesNothingOfANeedle) {
  // A triangle with a needle of 0.6 mm along the line of one of its sides.
  const Regions needle = {{{{3.84795, 7.14732},
                            {5.23509, 8.64228},
                            {4.48881, 8.82471},
                            {2.12562, 7.04441},
                            {1.42947, 6.51997},
                            {1.5753, 6.22312},
                            {3.77762, 6.82693},
                            {4.57103, 7.04447},
                            {4.00454, 6.88915}},
                           {}}};
  const double distance = 0.5 * 0.357079633;
  const Regions shrunk = offset(needle, -distance);
  ASSERT_FALSE(shrunk.empty());
  for (const Polygon& outline : outlines(shrunk))
    for (const Point2& point : outline)
      EXPECT_GT(test::distanceToOutline(outlines(needle), point), distance - 1e-4)
          << point.transpose() << " in an outline of " << perimeter(outline) << " mm";
}

TEST(Offset, TwiceIsTheSameAsOnceByTheSum) {
  EXPECT_TRUE(rc::check("walls may start from the wall before", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions regions = {{test::circle({0, 0}, random.uniform(3, 20), 64), {}}};
    const double first = random.uniform(0.1, 1.0);
    const double second = random.uniform(0.1, 1.0);
    RC_ASSERT(std::abs(area(offset(offset(regions, -first), -second)) -
                       area(offset(regions, -first - second))) < 1e-2);
  }));
}

}  // namespace
}  // namespace lamina
