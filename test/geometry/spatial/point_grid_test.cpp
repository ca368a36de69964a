// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/spatial/point_grid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

Box2 unitBox() { return {Point2(0, 0), Point2(10, 10)}; }

TEST(PointGrid, FindsThePointsThatLieNearWhereverTheyAre) {
  EXPECT_TRUE(rc::check("as going through all of them", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    PointGrid grid(unitBox(), random.uniform(0.1, 3.0));
    for (int i = 0; i < 60; ++i) grid.insert({random.uniform(-2, 12), random.uniform(-2, 12)});
    const Point2 place(random.uniform(-3, 13), random.uniform(-3, 13));
    const double radius = random.uniform(0.0, 5.0);
    std::size_t expected = 0;
    for (const Point2& point : grid.points()) expected += (point - place).norm() <= radius ? 1 : 0;
    std::size_t found = 0;
    grid.visitNear(place, radius, [&](std::uint32_t, double) { ++found; });
    RC_ASSERT(found == expected);
    RC_ASSERT(grid.hasNearer(place, radius) == (expected > 0));
  }));
}

TEST(PointGrid, FindsTheNearestPoint) {
  EXPECT_TRUE(rc::check("as going through all of them", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    PointGrid grid(unitBox(), 0.5);
    for (int i = 0; i < 40; ++i) grid.insert({random.uniform(0, 10), random.uniform(0, 10)});
    const Point2 place(random.uniform(-30, 30), random.uniform(-30, 30));
    const Point2 found = grid.points()[*grid.nearest(place, 0.0)];
    for (const Point2& point : grid.points()) RC_ASSERT((point - place).norm() >= (found - place).norm());
  }));
}

TEST(PointGrid, FindsThePointsInABox) {
  EXPECT_TRUE(rc::check("as going through all of them", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    PointGrid grid(unitBox(), random.uniform(0.1, 3.0));
    for (int i = 0; i < 60; ++i) grid.insert({random.uniform(-2, 12), random.uniform(-2, 12)});
    const Point2 low(random.uniform(-3, 13), random.uniform(-3, 13));
    const Point2 high = low + Point2(random.uniform(0, 6), random.uniform(0, 6));
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < grid.points().size(); ++i) {
      const Point2& point = grid.points()[i];
      if (point.x() >= low.x() && point.x() <= high.x() && point.y() >= low.y() && point.y() <= high.y())
        expected.push_back(i);
    }
    std::vector<std::uint32_t> found;
    grid.visitIn({low, high}, [&](std::uint32_t i) { found.push_back(i); });
    std::sort(found.begin(), found.end());
    RC_ASSERT(found == expected);
  }));
}

TEST(PointGrid, FindsWhetherANearPointPassesATest) {
  PointGrid grid(unitBox(), 1.0);
  grid.insert({1.0, 1.0});
  grid.insert({1.5, 1.0});
  const auto isSecond = [](std::uint32_t index, double) { return index == 1; };
  EXPECT_TRUE(grid.hasNear({1.0, 1.0}, 0.5, isSecond));
  EXPECT_FALSE(grid.hasNear({1.0, 1.0}, 0.4, isSecond));
}

TEST(PointGrid, GivesAllPointsNearestFirstAsTheyAreTaken) {
  EXPECT_TRUE(rc::check("equally near ones by their index", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    PointGrid grid(unitBox(), random.uniform(0.1, 5.0));
    std::vector<std::uint32_t> left;
    // On a lattice that goes beyond the box: many are equally near.
    for (int i = 0; i < 50; ++i)
      left.push_back(grid.insert({std::floor(random.uniform(-4, 14)), std::floor(random.uniform(-4, 14))}));
    while (!left.empty()) {
      const Point2 place(std::floor(random.uniform(-6, 16)), std::floor(random.uniform(-6, 16)));
      const auto distance = [&](std::uint32_t i) { return (grid.points()[i] - place).squaredNorm(); };
      const auto expected = std::min_element(left.begin(), left.end(), [&](std::uint32_t a, std::uint32_t b) {
        return distance(a) < distance(b);
      });
      RC_ASSERT(grid.nearest(place) == *expected);
      grid.remove(*expected);
      left.erase(expected);
    }
    RC_ASSERT(!grid.nearest({0.0, 0.0}).has_value());
  }));
}

TEST(PointGrid, PrefersOfEquallyNearPointsThatOfSmallerX) {
  PointGrid grid(unitBox(), 1.0);
  grid.insert({6.0, 5.0});
  const std::uint32_t left = grid.insert({4.0, 5.0});
  EXPECT_EQ(grid.nearest({5.0, 5.0}, 1e-9), left);
  EXPECT_EQ(grid.nearest({5.0 + 1e-10, 5.0}, 1e-9), left) << "nearer to the right one by less than the tie";
}

TEST(PointGrid, FindsARemovedPointNoMore) {
  PointGrid grid(unitBox(), 1.0);
  const std::uint32_t only = grid.insert({1.0, 1.0});
  grid.remove(only);
  EXPECT_FALSE(grid.nearest({1.0, 1.0}, 0.0).has_value());
  EXPECT_FALSE(grid.hasNearer({1.0, 1.0}, 1.0));
}

TEST(PointGrid, TakesABoxOfNothing) {
  PointGrid grid(Box2{}, 1.0);
  EXPECT_FALSE(grid.nearest({0.0, 0.0}, 0.0).has_value());
  grid.insert({3.0, -2.0});
  EXPECT_TRUE(grid.hasNearer({3.0, -2.5}, 1.0));
}

}  // namespace
}  // namespace lamina
