// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/moving_average.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace lamina {
namespace {

std::vector<Point3> onAxis(const std::vector<double>& values) {
  std::vector<Point3> points;
  for (const double value : values) points.emplace_back(value, 0.0, 0.0);
  return points;
}

void expectOnAxis(const std::vector<Point3>& points, const std::vector<double>& expected) {
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(points[i].x(), expected[i], 1e-12) << i;
}

TEST(MovingAverage, GoesRoundAClosedCourse) {
  expectOnAxis(movingAverages(onAxis({0, 3, 6, 0}), Course::Closed, 1), {1, 3, 3, 2});
}

TEST(MovingAverage, ShrinksTowardsTheEndsOfAnOpenOne) {
  expectOnAxis(movingAverages(onAxis({0, 3, 9, 0, 3}), Course::Open, 2), {0, 4, 3, 4, 3});
}

TEST(MovingAverage, RunsRoundAShortCourseMoreThanOnce) {
  // Five of two: three times one of them and twice the other.
  expectOnAxis(movingAverages(onAxis({0, 5}), Course::Closed, 2), {2, 3});
}

TEST(MovingAverage, OfNothingIsNothing) { EXPECT_TRUE(movingAverages({}, Course::Closed, 3).empty()); }

TEST(MovingAverage, IsTheMeanOfTheWindowCountedOneByOne) {
  EXPECT_TRUE(rc::check([] {
    const auto count = *rc::gen::inRange<std::size_t>(1, 30);
    const auto reach = *rc::gen::inRange<std::size_t>(0, 50);
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(*rc::gen::inRange(-1000, 1000));
    const std::vector<Point3> means = movingAverages(onAxis(values), Course::Closed, reach);
    for (std::size_t i = 0; i < count; ++i) {
      double sum = 0.0;
      for (std::size_t k = 0; k <= 2 * reach; ++k)
        sum += values[(i + k + (reach / count + 1) * count - reach) % count];
      RC_ASSERT(std::abs(means[i].x() - sum / static_cast<double>(2 * reach + 1)) < 1e-9);
    }
  }));
}

}  // namespace
}  // namespace lamina
