// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/crossed_outlines.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/polygon/divided_area.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

double areaIn(const std::optional<Regions>& regions) { return regions ? area(*regions) : -1.0; }

TEST(CrossedOutlines, OfTwoSquaresAreTheirCornerAndTheRest) {
  const Regions a = {{rectangle(0, 0, 10, 10), {}}};
  const Regions b = {{rectangle(6, 7, 20, 20), {}}};
  const CrossedOutlines crossed(a, b);
  const std::optional<Regions> common = crossed.common();
  ASSERT_TRUE(common.has_value());
  ASSERT_EQ(common->size(), 1U);
  EXPECT_EQ(common->front().outer.size(), 4U);
  EXPECT_NEAR(area(*common), 12.0, 1e-9);
  EXPECT_NEAR(areaIn(crossed.rest()), 88.0, 1e-9);
}

TEST(CrossedOutlines, OfACrossAreFourPieces) {
  const Regions a = {{rectangle(0, 4, 10, 6), {}}};
  const Regions b = {{rectangle(2, 0, 3, 10), {}}, {rectangle(7, 0, 9, 10), {}}};
  const CrossedOutlines crossed(a, b);
  const std::optional<Regions> common = crossed.common();
  const std::optional<Regions> rest = crossed.rest();
  ASSERT_TRUE(common && rest);
  EXPECT_EQ(common->size(), 2U);
  EXPECT_NEAR(area(*common), 6.0, 1e-9);
  EXPECT_EQ(rest->size(), 3U);
  EXPECT_NEAR(area(*rest), 14.0, 1e-9);
}

TEST(CrossedOutlines, KeepHoles) {
  const Regions ring = {{rectangle(0, 0, 10, 10), {test::reversed(rectangle(3, 3, 7, 7))}}};
  const Regions inner = {{rectangle(2, 2, 8, 8), {}}};
  const CrossedOutlines crossed(ring, inner);
  const std::optional<Regions> common = crossed.common();
  ASSERT_TRUE(common.has_value());
  ASSERT_EQ(common->size(), 1U);
  EXPECT_EQ(common->front().holes.size(), 1U);
  EXPECT_NEAR(area(*common), 20.0, 1e-9);
  EXPECT_NEAR(areaIn(crossed.rest()), 64.0, 1e-9);
  EXPECT_NEAR(areaIn(CrossedOutlines(inner, ring).rest()), 16.0, 1e-9);
}

TEST(CrossedOutlines, ThatStayApartAreNestedOrNot) {
  const Regions a = {{rectangle(0, 0, 10, 10), {}}};
  const Regions beside = {{rectangle(11, 0, 20, 10), {}}};
  const Regions around = {{rectangle(-1, -1, 20, 20), {}}};
  EXPECT_EQ(areaIn(CrossedOutlines(a, beside).common()), 0.0);
  EXPECT_EQ(areaIn(CrossedOutlines(a, beside).rest()), 100.0);
  EXPECT_EQ(areaIn(CrossedOutlines(a, around).common()), 100.0);
  EXPECT_EQ(areaIn(CrossedOutlines(a, around).rest()), 0.0);
  EXPECT_EQ(areaIn(CrossedOutlines(around, a).rest()), 341.0);
  EXPECT_EQ(areaIn(CrossedOutlines(a, {}).rest()), 100.0);
  EXPECT_EQ(areaIn(CrossedOutlines({}, a).common()), 0.0);
}

TEST(CrossedOutlines, AreFoundInAnAreaThatOverlapsItself) {
  const Regions a = {{rectangle(4, 4, 6, 6), {}}};
  const Regions nested = {{rectangle(0, 0, 10, 10), {}}, {rectangle(2, 2, 8, 8), {}}};
  const Regions overlapping = {{rectangle(0, 0, 7, 10), {}}, {rectangle(3, 1, 10, 9), {}}};
  for (const Regions& around : {nested, overlapping}) {
    EXPECT_NEAR(area(intersection(a, around)), 4.0, 1e-9);
    EXPECT_TRUE(difference(a, around).empty());
  }
  // Of the whole a square is left out twice.
  const Regions whole = {{rectangle(-1, -1, 11, 11), {}}};
  EXPECT_NEAR(area(difference(whole, nested)), 44.0, 1e-6);
  EXPECT_NEAR(area(intersection(nested, whole)), 100.0, 1e-6);
  EXPECT_NEAR(area(difference(whole, overlapping)), 144.0 - 94.0, 1e-6);
  EXPECT_NEAR(area(intersection(overlapping, whole)), 94.0, 1e-6);
  // Along each other, and the same twice.
  const Regions level = {{rectangle(0, 0, 7, 10), {}}, {rectangle(3, 0, 10, 10), {}}};
  const Regions twice = {{rectangle(0, 0, 10, 10), {}}, {rectangle(0, 0, 10, 10), {}}};
  for (const Regions& each : {level, twice}) {
    EXPECT_NEAR(area(difference(whole, each)), 144.0 - 100.0, 1e-6);
    EXPECT_NEAR(area(intersection(each, whole)), 100.0, 1e-6);
    EXPECT_NEAR(area(difference(each, {{rectangle(-1, 4, 11, 6), {}}})), 80.0, 1e-6);
  }
  // A bar over the border of a ring's hole.
  const Regions ring = {{rectangle(0, 0, 10, 10), {test::reversed(rectangle(3, 3, 7, 7))}},
                        {rectangle(2, 4, 5, 6), {}}};
  EXPECT_NEAR(area(difference(whole, ring)), 144.0 - (84.0 + 4.0), 1e-6);
}

/// Stars that lie anywhere in a square, so that some of them overlap.
Regions scatteredStars(Random& random, int count) {
  Regions regions;
  for (int i = 0; i < count; ++i) {
    const Point2 centre(random.uniform(0, 30), random.uniform(0, 30));
    regions.push_back({test::star(random, centre, 1.0, 5.0, 12), {}});
    if (i % 2 == 0) regions.back().holes.push_back(test::reversed(test::star(random, centre, 0.3, 0.8, 6)));
  }
  return regions;
}

TEST(CrossedOutlines, OfAreasThatOverlapThemselvesAreThoseOfTheirUnions) {
  int tried = 0;
  int overlapping = 0;
  EXPECT_TRUE(rc::check("scattered stars", [&] {
    ++tried;
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions a = scatteredStars(random, random.uniform(0, 1) < 0.5 ? 1 : 5);
    const Regions b = scatteredStars(random, 6);
    const Regions whole_a = unite(outlines(a));
    const Regions whole_b = unite(outlines(b));
    overlapping += area(b) > area(whole_b) + 0.1 ? 1 : 0;
    const Regions common = intersection(a, b);
    const Regions rest = difference(a, b);
    RC_ASSERT(std::abs(area(common) - area(intersection(whole_a, whole_b))) < 1e-2);
    RC_ASSERT(std::abs(area(rest) - area(difference(whole_a, whole_b))) < 1e-2);
    for (int i = 0; i < 100; ++i) {
      const Point2 point(random.uniform(-5, 35), random.uniform(-5, 35));
      const bool is_in_a = contains(outlines(whole_a), point);
      const bool is_in_b = contains(outlines(whole_b), point);
      RC_ASSERT(contains(outlines(common), point) == (is_in_a && is_in_b));
      RC_ASSERT(contains(outlines(rest), point) == (is_in_a && !is_in_b));
    }
  }));
  EXPECT_GT(overlapping, 0.6 * tried) << "or the property says nothing";
}

TEST(CrossedOutlines, SayNothingWhereTheyTouch) {
  const Regions a = {{rectangle(0, 0, 10, 10), {}}};
  EXPECT_FALSE(CrossedOutlines(a, a).common());
  EXPECT_FALSE(CrossedOutlines(a, {{rectangle(10, 0, 20, 10), {}}}).rest());
  EXPECT_FALSE(CrossedOutlines(a, {{rectangle(2, 0, 8, 5), {}}}).rest());
  EXPECT_FALSE(CrossedOutlines(a, {{rectangle(10, 10, 20, 20), {}}}).common());
}

TEST(CrossedOutlines, SayNothingWhereTheyTouchButForRounding) {
  const Regions a = {{rectangle(0, 0, 10, 10), {}}};
  const Regions b = {{rectangle(-1, 9.999995, 11, 20), {}}};
  EXPECT_FALSE(CrossedOutlines(a, b).common());
  EXPECT_LT(area(intersection(a, b)), 1e-3);
}

/// Stars with a hole each, which cross in many places.
Regions randomRing(Random& random, const Point2& centre) {
  return {
      {test::star(random, centre, 5.0, 8.0, 40), {test::reversed(test::star(random, centre, 2.0, 4.0, 30))}}};
}

TEST(CrossedOutlines, ShareOutRandomRings) {
  int tried = 0;
  int clear = 0;
  EXPECT_TRUE(rc::check("random rings", [&] {
    ++tried;
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions a = randomRing(random, {0, 0});
    const Regions b = randomRing(random, {random.uniform(0, 6), random.uniform(0, 6)});
    const CrossedOutlines crossed(a, b);
    const CrossedOutlines swapped(b, a);
    const std::optional<Regions> common = crossed.common();
    const std::optional<Regions> rest = crossed.rest();
    if (!common || !rest) return;
    ++clear;
    RC_ASSERT(std::abs(area(*common) + area(*rest) - area(a)) < 1e-3);
    RC_ASSERT(std::abs(areaIn(swapped.common()) - area(*common)) < 1e-3);
    for (int i = 0; i < 200; ++i) {
      const Point2 point(random.uniform(-9, 15), random.uniform(-9, 15));
      const bool is_in_a = contains(outlines(a), point);
      const bool is_in_b = contains(outlines(b), point);
      RC_ASSERT(contains(outlines(*common), point) == (is_in_a && is_in_b));
      RC_ASSERT(contains(outlines(*rest), point) == (is_in_a && !is_in_b));
    }
  }));
  EXPECT_GT(clear, 0.8 * tried) << "or the property says nothing";
}

/// Where outlines of the one cross those of the other, and the corners of both.
std::vector<Point2> exactCorners(const Regions& a, const Regions& b) {
  std::vector<Point2> corners;
  for (const Regions& regions : {a, b})
    for (const Polygon& outline : outlines(regions))
      corners.insert(corners.end(), outline.begin(), outline.end());
  for (const Polygon& of_a : outlines(a))
    for (const Polygon& of_b : outlines(b))
      for (std::size_t i = 0; i < of_a.size(); ++i)
        for (std::size_t j = 0; j < of_b.size(); ++j) {
          const Point2& from = of_a[i];
          const Point2 way = of_a[(i + 1) % of_a.size()] - from;
          const Point2 other = of_b[(j + 1) % of_b.size()] - of_b[j];
          Eigen::Matrix2d ways;
          ways << way, -other;
          if (std::abs(ways.determinant()) < 1e-12) continue;
          const Point2 along = ways.inverse() * (of_b[j] - from);
          if ((along.array() >= 0.0).all() && (along.array() <= 1.0).all())
            corners.push_back(from + along.x() * way);
        }
  return corners;
}

TEST(CrossedOutlines, HaveTheExactCorners) {
  std::size_t tried = 0;
  std::size_t seen = 0;
  EXPECT_TRUE(rc::check("random rings", [&] {
    ++tried;
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions a = randomRing(random, {0, 0});
    const Regions b = randomRing(random, {random.uniform(0, 6), random.uniform(0, 6)});
    const CrossedOutlines crossed(a, b);
    const std::vector<Point2> exact = exactCorners(a, b);
    for (const std::optional<Regions>& found : {crossed.common(), crossed.rest()}) {
      if (!found) continue;
      for (const Polygon& outline : outlines(*found))
        for (const Point2& corner : outline) {
          double nearest = 1.0;
          for (const Point2& other : exact) nearest = std::min(nearest, (other - corner).norm());
          RC_ASSERT(nearest <= 1e-5);
          ++seen;
        }
    }
  }));
  EXPECT_GT(seen, 50 * tried);
}

/// What is left of an area meets it, but for rounding.
TEST(CrossedOutlines, AreTrueOfWhatRoundingLeft) {
  EXPECT_TRUE(rc::check("leavings of random stars", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions a = {{test::star(random, {0, 0}, 3.0, 8.0, 12), {}}};
    const double reach = random.uniform(0.05, 0.5);
    const Regions opened = offset(offset(a, -reach), reach);
    const Regions left = difference(a, opened);
    const DividedArea back = divided(a, left);
    const DividedArea again = divided(left, back.common);
    RC_ASSERT(std::abs(area(back.rest) + area(left) - area(a)) < 1e-2);
    RC_ASSERT(std::abs(area(back.common) - area(left)) < 1e-2);
    RC_ASSERT(area(again.rest) < 1e-2);
  }));
}

TEST(DividedArea, IsSharedOutWhereOutlinesMeetToo) {
  const Regions a = {{rectangle(0, 0, 10, 10), {}}};
  const Regions b = {{rectangle(5, 0, 10, 10), {}}};
  const DividedArea both = divided(a, b);
  EXPECT_NEAR(area(both.common), 50.0, 1e-9);
  EXPECT_NEAR(area(both.rest), 50.0, 1e-9);
  EXPECT_NEAR(area(divided(a, {}).rest), 100.0, 1e-9);
  EXPECT_TRUE(divided({}, a).rest.empty());
}

}  // namespace
}  // namespace lamina
