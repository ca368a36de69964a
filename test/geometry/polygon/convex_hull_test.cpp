// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/polygon/convex_hull.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/shapes.hpp"

namespace lamina {
namespace {

TEST(ConvexHull, OfASquareWithPointsInsideAndOnItsEdgesIsTheSquare) {
  const Polygon hull =
      convexHull({{5, 5}, {0, 0}, {5, 0}, {10, 0}, {10, 10}, {3, 7}, {0, 10}, {0, 4}, {0, 0}});
  EXPECT_EQ(hull.size(), 4U);
  EXPECT_DOUBLE_EQ(signedArea(hull), 100.0);
}

TEST(ConvexHull, OfPointsOnALineIsEmpty) {
  EXPECT_TRUE(convexHull({}).empty());
  EXPECT_TRUE(convexHull({{1, 1}}).empty());
  EXPECT_TRUE(convexHull({{0, 0}, {1, 1}, {3, 3}, {2, 2}}).empty());
}

TEST(ConvexHull, HoldsAllPointsAndTurnsLeftOnly) {
  EXPECT_TRUE(rc::check("any points", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Polygon points = test::star(random, {0, 0}, 0.0, 5.0, *rc::gen::inRange(3, 60));
    const Polygon hull = convexHull(points);
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Point2 edge = hull[(i + 1) % hull.size()] - hull[i];
      for (const Point2& point : points) {
        const Point2 offset = point - hull[i];
        RC_ASSERT(edge.x() * offset.y() - edge.y() * offset.x() > -1e-9);
      }
    }
  }));
}

}  // namespace
}  // namespace lamina
