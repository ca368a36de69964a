// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/outline_crossings.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

TEST(OutlineCrossings, AreNotSeenInSimpleOutlinesApart) {
  EXPECT_TRUE(areSurelyApart({}));
  EXPECT_TRUE(areSurelyApart({rectangle(0, 0, 10, 10), rectangle(2, 2, 8, 8), rectangle(10.1, 0, 20, 10)}));
  EXPECT_TRUE(areSurelyApart({test::circle({0, 0}, 5, 1000)}));
}

TEST(OutlineCrossings, AreSeenWhereOutlinesCrossTouchOrFoldBack) {
  EXPECT_FALSE(areSurelyApart({rectangle(0, 0, 10, 10), rectangle(5, 5, 15, 15)}));
  EXPECT_FALSE(areSurelyApart({rectangle(0, 0, 10, 10), rectangle(10, 0, 20, 10)}));
  EXPECT_FALSE(areSurelyApart({rectangle(0, 0, 10, 10), rectangle(10, 10, 20, 20)}));
  EXPECT_FALSE(areSurelyApart({rectangle(0, 0, 10, 10), rectangle(0, 0, 10, 10)}));
  EXPECT_FALSE(areSurelyApart({Polygon{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}));
  EXPECT_FALSE(areSurelyApart({Polygon{{0, 0}, {10, 0}, {5, 0}, {5, 5}}}));
  EXPECT_FALSE(areSurelyApart({Polygon{{0, 0}, {10, 0}, {5, 5}, {10, 10}, {0, 10}, {5, 5}}}));
}

bool crosses(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const auto side = [](const Point2& p, const Point2& q, const Point2& r) {
    return (q - p).x() * (r - p).y() - (q - p).y() * (r - p).x();
  };
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

TEST(OutlineCrossings, AreSeenAsByComparingEachEdgeWithEach) {
  EXPECT_TRUE(rc::check("random outlines", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Point2 offset(random.uniform(0, 12), 0);
    const Polygon a = test::star(random, {0, 0}, 3.0, 5.0, 15);
    const Polygon b = test::star(random, offset, 3.0, 5.0, 15);
    bool is_crossing = false;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t k = 0; k < b.size(); ++k)
        is_crossing |= crosses(a[i], a[(i + 1) % a.size()], b[k], b[(k + 1) % b.size()]);
    RC_ASSERT(areSurelyApart({a, b}) != is_crossing);
  }));
}

}  // namespace
}  // namespace lamina
