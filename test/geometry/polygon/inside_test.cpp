// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/inside.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

const Regions kRing = {{test::rectangle(0, 0, 20, 20), {test::reversed(test::rectangle(5, 5, 15, 15))}}};

TEST(StaysInside, IsTrueWithinMaterialOnly) {
  EXPECT_TRUE(staysInside(kRing, {1, 1}, {19, 4}));
  EXPECT_FALSE(staysInside(kRing, {1, 10}, {19, 10})) << "across the hole";
  EXPECT_FALSE(staysInside(kRing, {1, 1}, {25, 1})) << "out of the part";
  EXPECT_FALSE(staysInside(kRing, {7, 7}, {12, 12})) << "in the hole";
  EXPECT_FALSE(staysInside(kRing, {25, 0}, {30, 30})) << "beside the part";
  EXPECT_FALSE(staysInside({}, {0, 0}, {1, 1}));
}

TEST(StaysInside, LetsItsEndsLieOnOutlines) {
  EXPECT_TRUE(staysInside(kRing, {0, 3}, {5, 10}));
  EXPECT_TRUE(staysInside(kRing, {0, 0}, {5, 5}));
  EXPECT_FALSE(staysInside(kRing, {5, 10}, {15, 10})) << "both ends on the hole";
}

TEST(StaysInside, AgreesWithPointsAlongTheLine) {
  EXPECT_TRUE(rc::check("random lines", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions regions = unite(
        {test::star(random, {0, 0}, 5.0, 10.0, 12), test::reversed(test::star(random, {0, 0}, 1.0, 4.0, 8))});
    const std::vector<Polygon> borders = outlines(regions);
    const Point2 from(random.uniform(-8, 8), random.uniform(-8, 8));
    const Point2 to(random.uniform(-8, 8), random.uniform(-8, 8));
    if (!staysInside(regions, from, to)) return;
    for (int i = 0; i <= 100; ++i) {
      const Point2 point = from + 0.01 * i * (to - from);
      RC_ASSERT(contains(borders, point) || test::distanceToOutline(borders, point) < 1e-3);
    }
  }));
}

TEST(StaysInside, IsJudgedAlikeOfManyLines) {
  EXPECT_TRUE(rc::check("random lines", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    std::vector<Polygon> stars;
    for (int i = 0; i < 6; ++i)
      stars.push_back(test::star(random, {random.uniform(-8, 8), random.uniform(-8, 8)}, 1.0, 4.0, 9));
    const Regions regions = unite(stars);
    const InsideTest test(regions);
    for (int i = 0; i < 50; ++i) {
      const Point2 from(random.uniform(-8, 8), random.uniform(-8, 8));
      const Point2 to(random.uniform(-8, 8), random.uniform(-8, 8));
      RC_ASSERT(test.staysInside(from, to) == staysInside(regions, from, to));
    }
  }));
  EXPECT_FALSE(InsideTest({}).staysInside({0, 0}, {1, 1}));
}

}  // namespace
}  // namespace lamina
