// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/overhangs/border_distance.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

TEST(BorderDistance, IsNegativeInsideAndEndsAtTheReach) {
  const Regions ring = unite({rectangle(0, 0, 10, 10), test::reversed(rectangle(4, 4, 6, 6))});
  const BorderDistance distance(ring, 0.5);
  EXPECT_DOUBLE_EQ(distance.at({0.3, 5}), -0.3);
  EXPECT_DOUBLE_EQ(distance.at({-0.2, 5}), 0.2);
  EXPECT_NEAR(distance.at({-0.3, -0.4}), 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(distance.at({2, 5}), -0.5);
  EXPECT_DOUBLE_EQ(distance.at({5, 5}), 0.5) << "in the hole";
  EXPECT_NEAR(distance.at({4.1, 5}), 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(distance.at({1e5, -1e5}), 0.5);
}

TEST(BorderDistance, OfNoRegionIsTheReach) {
  EXPECT_EQ(BorderDistance({}, 0.4).at({0, 0}), 0.4);
  EXPECT_FALSE(BorderDistance({}, 0.4).isInside({0, 0}));
}

TEST(BorderDistance, EqualsTheDistanceToEveryEdge) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    std::vector<Polygon> stars;
    for (int i = 0; i < 3; ++i)
      stars.push_back(test::star(random, {random.uniform(-20, 20), random.uniform(-20, 20)}, 2.0, 12.0,
                                 3 + static_cast<int>(random.below(60))));
    const Regions regions = unite(stars);
    const std::vector<Polygon> borders = outlines(regions);
    const double reach = random.uniform(0.1, 3.0);
    const BorderDistance distance(regions, reach);
    for (int i = 0; i < 200; ++i) {
      const Point2 point(random.uniform(-35, 35), random.uniform(-35, 35));
      const double truth = std::min(test::distanceToOutline(borders, point), reach);
      RC_ASSERT(std::abs(distance.at(point) - (contains(borders, point) ? -truth : truth)) < 1e-9);
    }
  }));
}

}  // namespace
}  // namespace lamina
