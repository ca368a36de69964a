// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/crossed_outlines.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

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
  int clear = 0;
  EXPECT_TRUE(rc::check("random rings", [&clear] {
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
  EXPECT_GT(clear, 80) << "of a hundred, or the property says nothing";
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
