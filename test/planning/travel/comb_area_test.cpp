// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/travel/comb_area.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/polygon/inside.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;

constexpr WayLimits kAnyWay = {1e6, 0.5};

/// 30 x 30 mm with a notch of 10 x 20 mm from the top.
Regions letterU() {
  return {{{{0, 0}, {30, 0}, {30, 30}, {20, 30}, {20, 10}, {10, 10}, {10, 30}, {0, 30}}, {}}};
}

double wayLength(const Regions& area, const Point2& from, const Point2& to,
                 const WayLimits& limits = kAnyWay) {
  const auto way = CombArea(area).shortestWay(from, to, limits);
  return way ? length(*way) : -1.0;
}

TEST(CombArea, GoesRoundANotch) {
  const CombArea area(letterU());
  const auto way = area.shortestWay({5, 28}, {25, 28}, kAnyWay);
  ASSERT_TRUE(way);
  EXPECT_EQ(*way, (Polyline{{5, 28}, {10, 10}, {20, 10}, {25, 28}}));
  EXPECT_NEAR(length(*way), 2 * std::hypot(5, 18) + 10, 1e-9);
  EXPECT_NEAR(length(*way), 47.363, 1e-3);
}

TEST(CombArea, RefusesWaysThatAreTooLong) {
  EXPECT_GT(wayLength(letterU(), {5, 28}, {25, 28}, {3 * 20.0, 0.5}), 47.0);
  EXPECT_EQ(wayLength(letterU(), {5, 28}, {25, 28}, {2 * 20.0, 0.5}), -1.0);
}

TEST(CombArea, IsStraightWhereItCanBe) {
  EXPECT_NEAR(wayLength(letterU(), {5, 28}, {5, 2}), 26.0, 1e-12);
  EXPECT_NEAR(wayLength(letterU(), {1, 1}, {29, 9}), std::hypot(28, 8), 1e-12);
}

TEST(CombArea, GoesRoundAHoleOnTheShorterSide) {
  const double radius = 5.0;
  const Regions area = {{rectangle(-20, -20, 20, 20), {test::reversed(circle({0, 1}, radius, 720))}}};
  // Tangents from both ends to the circle, 1 mm above the line between them, and the arc below.
  const double to_centre = std::hypot(15, 1);
  const double tangent = std::sqrt(to_centre * to_centre - radius * radius);
  const double angle = 2 * std::atan2(15, 1) - 2 * std::acos(radius / to_centre);
  EXPECT_NEAR(wayLength(area, {-15, 0}, {15, 0}), 2 * tangent + radius * angle, 1e-3);
}

TEST(CombArea, FindsNoWayToAnotherRegion) {
  const Regions area = {{rectangle(0, 0, 10, 10), {}}, {rectangle(11, 0, 20, 10), {}}};
  EXPECT_EQ(wayLength(area, {5, 5}, {15, 5}), -1.0);
  EXPECT_NEAR(wayLength(area, {5, 5}, {5, 9}), 4.0, 1e-12);
  const CombArea none{Regions()};
  EXPECT_FALSE(none.shortestWay({0, 0}, {1, 0}, kAnyWay));
}

TEST(CombArea, JoinsEndsBesideTheArea) {
  EXPECT_NEAR(wayLength(letterU(), {-0.3, 20}, {-0.3, 10}), 10.6, 1e-3) << "in, along, out";
  EXPECT_EQ(wayLength(letterU(), {-0.6, 20}, {5, 10}), -1.0) << "beyond the reach";
  EXPECT_EQ(wayLength(letterU(), {15, 28}, {5, 10}), -1.0);
}

/// Shortest way by all pairs of corners that see each other, along edges too: hardly beside the area counts
/// as within.
double byAllCorners(const Regions& area, const Point2& from, const Point2& to) {
  const Regions wider = offset(area, 1e-3);
  std::vector<Point2> places = {from, to};
  for (const Polygon& outline : outlines(area)) places.insert(places.end(), outline.begin(), outline.end());
  std::vector<double> way(places.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> is_done(places.size(), false);
  way[0] = 0.0;
  for (;;) {
    std::size_t next = places.size();
    for (std::size_t i = 0; i < places.size(); ++i)
      if (!is_done[i] && (next == places.size() || way[i] < way[next])) next = i;
    if (next == places.size() || std::isinf(way[next])) return way[1];
    is_done[next] = true;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double beyond = way[next] + (places[i] - places[next]).norm();
      if (!is_done[i] && beyond < way[i] && staysInside(wider, places[next], places[i])) way[i] = beyond;
    }
  }
}

TEST(CombArea, FindsTheShortestWaysInStarsWithHoles) {
  Random random(7);
  int bent = 0;
  for (int round = 0; round < 60; ++round) {
    // Holes that overlap each other or the outline are united before.
    const Regions outer = {{test::star(random, {0, 0}, 8.0, 20.0, 14), {}}};
    Regions holes;
    for (int i = 0; i < 3; ++i)
      holes.push_back({test::star(random, {random.uniform(-7, 7), random.uniform(-7, 7)}, 1.0, 3.0, 7), {}});
    const Regions area = difference(outer, unite(outlines(holes)));
    const CombArea comb(area);
    for (int pair = 0; pair < 20; ++pair) {
      const Point2 from(random.uniform(-15, 15), random.uniform(-15, 15));
      const Point2 to(random.uniform(-15, 15), random.uniform(-15, 15));
      if (!contains(outlines(area), from) || !contains(outlines(area), to)) continue;
      const double expected = byAllCorners(area, from, to);
      const auto way = comb.shortestWay(from, to, {1e6, 0.0});
      if (std::isinf(expected)) {
        EXPECT_FALSE(way);
        continue;
      }
      ASSERT_TRUE(way) << "round " << round << ", pair " << pair;
      EXPECT_NEAR(length(*way), expected, 2e-3) << "round " << round << ", pair " << pair;
      for (std::size_t i = 0; i + 1 < way->size(); ++i)
        EXPECT_TRUE(staysInside(offset(area, 1e-3), (*way)[i], (*way)[i + 1])) << "round " << round;
      bent += way->size() > 2 ? 1 : 0;
    }
  }
  EXPECT_GT(bent, 100);
}

TEST(CombArea, LeadsThroughAPerforatedPlate) {
  Region plate = {rectangle(-4, -4, 84, 84), {}};
  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j <= 10; ++j) plate.holes.push_back(test::reversed(circle({8.0 * i, 8.0 * j}, 3.0, 48)));
  const Regions wider = offset({plate}, 1e-3);
  const CombArea area({plate});
  Random random(3);
  for (int pair = 0; pair < 100; ++pair) {
    const Point2 from(random.uniform(-3, 83), random.uniform(-3, 83));
    const Point2 to(random.uniform(-3, 83), random.uniform(-3, 83));
    if (!contains(outlines({plate}), from) || !contains(outlines({plate}), to)) continue;
    const double straight = (to - from).norm();
    const auto way = area.shortestWay(from, to, {1e6, 0.0});
    ASSERT_TRUE(way) << pair;
    // A way round each hole is half its rim at most, instead of its diameter.
    EXPECT_LE(length(*way), M_PI_2 * straight + 1e-6) << pair;
    for (std::size_t i = 0; i + 1 < way->size(); ++i)
      EXPECT_TRUE(staysInside(wider, (*way)[i], (*way)[i + 1])) << pair;
  }
}

}  // namespace
}  // namespace lamina
