// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/walls/opened_loop.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/shapes.hpp"

namespace lamina {
namespace {

Path joinedLoopOf(const Polygon& outline) {
  Path path;
  path.is_closed = true;
  for (const Point2& point : outline) path.points.emplace_back(point.x(), point.y(), 0.4);
  return path;
}

TEST(OpenedLoop, RunsRoundFromItsStartAndStopsShort) {
  const Path square = joinedLoopOf(test::rectangle(0, 0, 10, 10));
  const JoinedLoopPlace start = nearestPlace(square, {4, -1, 0});
  EXPECT_EQ(start.point, Point3(4, 0, 0.4));
  const Path as_given = opened(square, {start, LoopSense::AsGiven, 1.5});
  EXPECT_FALSE(as_given.is_closed);
  EXPECT_EQ(as_given.firstPoint(), Point3(4, 0, 0.4));
  EXPECT_NEAR((as_given.lastPoint() - Point3(2.5, 0, 0.4)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(length(as_given), 38.5, 1e-9);
  const Path reversed = opened(square, {start, LoopSense::Reversed, 1.5});
  EXPECT_NEAR((reversed.lastPoint() - Point3(5.5, 0, 0.4)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(length(reversed), 38.5, 1e-9);
}

TEST(OpenedLoop, EndsWhereItIsPredictedToEnd) {
  const auto agrees = [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Path joined_loop = joinedLoopOf(test::star(random, {3, 1}, 2.0, 9.0, *rc::gen::inRange(3, 60)));
    LoopOpening opening;
    opening.start = nearestPlace(
        joined_loop, {random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0), random.uniform(-1.0, 1.0)});
    opening.left_out_mm = random.uniform(0.0, 5.0);
    for (const LoopSense sense : {LoopSense::AsGiven, LoopSense::Reversed}) {
      opening.sense = sense;
      RC_ASSERT((endOfOpened(joined_loop, opening) - opened(joined_loop, opening).lastPoint()).norm() < 1e-5);
    }
  };
  EXPECT_TRUE(rc::check("in both senses", agrees));
}

}  // namespace
}  // namespace lamina
