// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/edge_collapse_inset.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <limits>
#include <utility>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::reversed;

/// Slivers as wide as the grid of clipping, along all of the outline [mm² / mm].
constexpr double kDisagreement = 1e-4;
/// Of corners computed from lines that turn by 0.01 rad at least [mm].
constexpr double kRounding = 1e-6;

/// The same by another way: what is left when everything around has grown. Growing always goes through
/// clipping.
Regions shrunkByClipping(const Region& region, double distance) {
  const Regions around = difference({{rectangle(-100, -100, 100, 100), {}}}, {region});
  return difference({region}, offset(around, distance));
}

TEST(EdgeCollapseInset, MovesEachEdgeOfASquare) {
  const auto shrunk = insetByEdgeCollapse({rectangle(0, 0, 10, 10), {}}, 1.0);
  ASSERT_TRUE(shrunk);
  EXPECT_NEAR(signedArea(shrunk->outer), 64.0, 1e-9);
}

TEST(EdgeCollapseInset, DropsAChamferThatVanishes) {
  const auto shrunk = insetByEdgeCollapse({{{0.1, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0.1}}, {}}, 1.0);
  ASSERT_TRUE(shrunk);
  EXPECT_EQ(shrunk->outer.size(), 4U);
  EXPECT_NEAR(signedArea(shrunk->outer), 64.0, 1e-9);
}

TEST(EdgeCollapseInset, DropsARoundedCornerSmallerThanTheDistance) {
  Polygon rounded = {{10, 0}, {10, 10}, {0, 10}};
  for (int i = 0; i <= 8; ++i) {
    const double angle = M_PI + i * M_PI / 16;
    rounded.emplace_back(0.5 + 0.5 * std::cos(angle), 0.5 + 0.5 * std::sin(angle));
  }
  const auto shrunk = insetByEdgeCollapse({rounded, {}}, 1.0);
  ASSERT_TRUE(shrunk);
  EXPECT_NEAR(signedArea(shrunk->outer), 64.0, 1e-9);
}

TEST(EdgeCollapseInset, DropsAnEdgeBesideAReflexCornerWhereItsNeighboursMeet) {
  // Turns by 45 degrees to the left and by 26.6 to the right, 0.1 mm from each other.
  const Polygon outline = {{0, 0}, {10, 0}, {10.1, 0.1}, {10.4, 0.2}, {16.4, 2.2}, {16.4, 12}, {0, 12}};
  const auto shrunk = insetByEdgeCollapse({outline, {}}, 1.0);
  ASSERT_TRUE(shrunk);
  // The lines y = 1 and (x - 10.1) / 3 + 0.1 + sqrt(10) / 3 = y meet.
  const Point2 meeting(10.1 + 3.0 * (0.9 - std::sqrt(10.0) / 3.0), 1.0);
  EXPECT_LT(test::distanceToOutline({shrunk->outer}, meeting), 1e-9);
  EXPECT_LT(area(difference({*shrunk}, shrunkByClipping({outline, {}}, 1.0))), 1e-3);
  EXPECT_LT(area(difference(shrunkByClipping({outline, {}}, 1.0), {*shrunk})), 1e-3);
}

TEST(EdgeCollapseInset, GrowsHoles) {
  const auto shrunk = insetByEdgeCollapse({rectangle(0, 0, 10, 10), {reversed(rectangle(4, 4, 6, 6))}}, 1.0);
  ASSERT_TRUE(shrunk);
  EXPECT_NEAR(area({*shrunk}), 64.0 - 16.0, 1e-9);
}

TEST(EdgeCollapseInset, LeavesToClippingWhatMeetsOrPasses) {
  const Polygon dumbbell = {{0, 0},   {10, 0},  {10, 4}, {20, 4}, {20, 0},  {30, 0},
                            {30, 10}, {20, 10}, {20, 6}, {10, 6}, {10, 10}, {0, 10}};
  EXPECT_FALSE(insetByEdgeCollapse({dumbbell, {}}, 1.5));
  EXPECT_FALSE(insetByEdgeCollapse({rectangle(0, 0, 10, 1), {}}, 0.6)) << "all edges turn round";
  const Region thin_ring = {circle({0, 0}, 10, 90), {reversed(circle({0, 0}, 9.7, 90))}};
  EXPECT_FALSE(insetByEdgeCollapse(thin_ring, 0.15)) << "the outlines meet";
  EXPECT_FALSE(insetByEdgeCollapse(thin_ring, 0.2)) << "they have passed each other";
  const Region two_holes = {rectangle(0, 0, 20, 10),
                            {reversed(rectangle(4, 4, 6, 6)), reversed(rectangle(7, 4, 9, 6))}};
  EXPECT_TRUE(insetByEdgeCollapse(two_holes, 0.4));
  EXPECT_FALSE(insetByEdgeCollapse(two_holes, 0.6));
  EXPECT_FALSE(insetByEdgeCollapse({{{0, 0}, {0, 0}, {5, 0}, {5, 5}}, {}}, 0.1)) << "a point stands twice";
  EXPECT_FALSE(insetByEdgeCollapse({}, 0.1));
}

/// The least distance between the outlines of two regions [mm]: that of a corner of one from the other.
double clearanceBetween(const Region& a, const Region& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : {std::pair{&a, &b}, std::pair{&b, &a}})
    for (const Polygon& outline : outlines({*from}))
      for (const Point2& corner : outline)
        least = std::min(least, test::distanceToOutline(outlines({*to}), corner));
  return least;
}

/// Checks that the direct way keeps all that clipping keeps, and nothing nearer than the distance. Between
/// the two lie mitres of clipping that are longer than they need to be.
/// @returns whether there is a direct way
bool keepsWhatItMust(const Region& region, double distance) {
  const auto shrunk = insetByEdgeCollapse(region, distance);
  if (!shrunk) return false;
  const double lost = area(difference(shrunkByClipping(region, distance), {*shrunk}));
  RC_ASSERT(lost / (perimeter(region.outer) + 1.0) < kDisagreement);
  RC_ASSERT(clearanceBetween(region, *shrunk) > distance - kRounding);
  return true;
}

TEST(EdgeCollapseInset, LeavesToClippingWhatAShortenedEdgeNoLongerHides) {
  // Found among 400 000 rough outlines: a corner lay 2.5 um nearer to a moved edge than the distance.
  Random random(382543134);
  const double roughness = random.uniform(0.0, 0.3);
  const Polygon outer = test::star(random, {0, 0}, 5.0 - roughness, 5.0, 337);
  const double distance = random.uniform(0.05, 1.5);
  EXPECT_NEAR(distance, 0.5485, 1e-4) << "or this is another outline";
  EXPECT_FALSE(insetByEdgeCollapse({outer, {}}, distance));
}

TEST(EdgeCollapseInset, GivesTheRegionThatClippingGives) {
  int tried = 0;
  int direct = 0;
  const auto agrees = [&] {
    ++tried;
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const double roughness = random.uniform(0.0, 1.0);
    const int points = *rc::gen::inRange(3, 120);
    const Polygon outer = test::star(random, {1, -3}, 12.0 - 4.0 * roughness, 12.0, points);
    const Polygon hole = reversed(test::star(random, {1, -3}, 4.0 - 3.0 * roughness, 4.0, points));
    const double distance = random.uniform(0.01, 2.0);
    for (const Region& region : unite({outer, hole})) direct += keepsWhatItMust(region, distance) ? 1 : 0;
  };
  EXPECT_TRUE(rc::check("wherever it gives one", agrees));
  EXPECT_GT(5 * direct, tried) << "or the property says nothing";
}

TEST(EdgeCollapseInset, GivesWhatClippingGivesOfOutlinesRougherThanTheDistance) {
  int direct = 0;
  const auto agrees = [&direct] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const double roughness = random.uniform(0.0, 0.3);
    const int points = *rc::gen::inRange(20, 400);
    const Polygon outer = test::star(random, {0, 0}, 5.0 - roughness, 5.0, points);
    direct += keepsWhatItMust({outer, {}}, random.uniform(0.05, 1.5)) ? 1 : 0;
  };
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(rc::check("wherever it gives one", agrees));
  EXPECT_GT(direct, 20) << "or the property says nothing";
}

}  // namespace
}  // namespace lamina
