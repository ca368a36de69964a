// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/spiral.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/fill_requests.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::requestOf;
using test::reversed;

TEST(Spiral, OfADiscTurnsOneWayFromTheBorderToTheMiddle) {
  const std::vector<FillPath> runs = spiral({{circle({0, 0}, 10, 180), {}}}, requestOf(0.4, 0.0));
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_FALSE(runs[0].is_closed);
  EXPECT_NEAR(runs[0].points.front().norm(), 9.8, 0.01);
  EXPECT_LT(runs[0].points.back().norm(), 0.5);
  double turned = 0.0;
  for (std::size_t i = 1; i < runs[0].points.size(); ++i) {
    const Point2& a = runs[0].points[i - 1];
    const Point2& b = runs[0].points[i];
    turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  // 25 contours, each but for its gap.
  EXPECT_NEAR(turned / (2.0 * M_PI), 25.0, 1.5);
}

TEST(Spiral, LaysAsMuchAsTheRegionHolds) {
  const Region square = {rectangle(0, 0, 20, 20), {}};
  const FillPath run = spiral({square}, requestOf(0.4, 0.0)).front();
  double filled = 0.0;
  for (std::size_t i = 1; i < run.points.size(); ++i)
    filled += run.width_mm[i] * (run.points[i] - run.points[i - 1]).norm();
  EXPECT_NEAR(filled / area({square}), 1.0, 0.01);
}

TEST(Spiral, TakesContoursRoundIslandsAlong) {
  const Region holed = {rectangle(-10, -10, 10, 10),
                        {reversed(circle({-5, 0}, 2.5, 60)), reversed(rectangle(2, -2, 5, 3))}};
  for (std::size_t layer = 0; layer < 20; ++layer) {
    InfillRequest request = requestOf(0.4, 0.0);
    request.layer = layer;
    const std::vector<FillPath> runs = spiral({holed}, request);
    ASSERT_EQ(runs.size(), 1U) << layer;
    EXPECT_FALSE(runs[0].is_closed);
  }
}

}  // namespace
}  // namespace lamina
