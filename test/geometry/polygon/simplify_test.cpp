// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/polygon/simplify.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/shapes.hpp"

namespace lamina {
namespace {

TEST(Simplify, LeavesOutPointsOnTheEdgesOfASquare) {
  Polygon square;
  for (int i = 0; i < 10; ++i) square.emplace_back(i, 0);
  for (int i = 0; i < 10; ++i) square.emplace_back(10, i);
  for (int i = 0; i < 10; ++i) square.emplace_back(10 - i, 10);
  for (int i = 0; i < 10; ++i) square.emplace_back(0, 10 - i);
  const Polygon simplified = simplify(square, 0.001);
  EXPECT_EQ(simplified.size(), 4U);
  EXPECT_DOUBLE_EQ(signedArea(simplified), 100.0);
}

TEST(Simplify, WithoutToleranceKeepsEveryCorner) {
  const Polygon polygon = test::circle({0, 0}, 5, 100);
  EXPECT_EQ(simplify(polygon, 0.0), polygon);
}

TEST(Simplify, LetsASliverVanish) {
  EXPECT_TRUE(simplify(Polygon{{0, 0}, {10, 0.001}, {20, 0}, {10, -0.001}}, 0.01).empty());
  EXPECT_TRUE(simplify(std::vector<Polygon>{{{0, 0}, {1, 1}}, {}, {{2, 2}, {2, 2}, {2, 2}}}, 0.01).empty());
}

TEST(Simplify, StaysWithinTheToleranceAndKeepsWhatHasAnArea) {
  EXPECT_TRUE(rc::check("any outline", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Polygon polygon =
        test::star(random, {1, 2}, 1.0, random.uniform(1.0, 3.0), *rc::gen::inRange(3, 200));
    const double tolerance = random.uniform(0.001, 0.5);
    const Polygon simplified = simplify(polygon, tolerance);
    if (std::abs(signedArea(polygon)) > tolerance * perimeter(polygon)) RC_ASSERT(simplified.size() >= 3U);
    if (simplified.empty()) return;
    for (const Point2& point : polygon)
      RC_ASSERT(test::distanceToOutline({simplified}, point) <= tolerance * (1 + 1e-9));
    for (const Point2& point : simplified) RC_ASSERT(std::count(polygon.begin(), polygon.end(), point) > 0);
  }));
}

}  // namespace
}  // namespace lamina
