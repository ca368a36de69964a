// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "metrics/straight_beads.hpp"

#include <gtest/gtest.h>

#include "support/toolpaths.hpp"

namespace lamina {
namespace {

std::vector<StraightBead> straightBeads(const Toolpath& toolpath) {
  return lamina::straightBeads(toolpath, BeadLine::Middle);
}

Toolpath of(const std::vector<Path>& paths) { return {"pieces", {{0.2, 0.2, paths}}}; }

Path through(const std::vector<Point3>& points) {
  Path path = test::straightPath(points[0], points[1]);
  path.points = points;
  return path;
}

TEST(StraightBeads, FollowTheMiddleOfTheBeadOrTheTip) {
  const Toolpath line = of({through({{0, 0, 0.2}, {3, 0, 0.2}})});
  EXPECT_EQ(lamina::straightBeads(line, BeadLine::Tip)[0].end, Point3(3, 0, 0.2));
  const std::vector<StraightBead> pieces = straightBeads(of({through({{0, 0, 0.2}, {3, 0, 0.2}})}));
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_TRUE(pieces[0].start.isApprox(Point3(0, 0, 0.1)));
  EXPECT_TRUE(pieces[0].end.isApprox(Point3(3, 0, 0.1)));
}

TEST(StraightBeads, WhatGoesOnStraightIsOnePiece) {
  const auto pieces = straightBeads(of({through({{0, 0, 1}, {1, 0, 1}, {1, 0, 1}, {2, 0, 1}, {2, 5, 1}})}));
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_TRUE(pieces[0].before.isZero());
  EXPECT_TRUE(pieces[0].after.isApprox(Point3(0, 1, 0)));
  EXPECT_TRUE(pieces[1].before.isApprox(Point3(1, 0, 0)));
  EXPECT_TRUE(pieces[1].after.isZero());
}

TEST(StraightBeads, AManySidedCircleIsNotStraight) {
  std::vector<Point3> points;
  for (int i = 0; i <= 200000; ++i)
    points.emplace_back(std::cos(2e-5 * i), std::sin(2e-5 * i),
                        1.0);  // each step turns less than is reported
  const auto pieces = straightBeads(of({through(points)}));
  EXPECT_GT(pieces.size(), 1000U);
  for (const StraightBead& piece : pieces) EXPECT_NEAR(piece.start.head<2>().norm(), 1.0, 1e-9);
}

TEST(StraightBeads, ClosedPathsJoinTheirEnds) {
  Path square = through({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}});
  square.is_closed = true;
  const auto pieces = straightBeads(of({square}));
  ASSERT_EQ(pieces.size(), 4U);
  EXPECT_TRUE(pieces[0].before.isApprox(Point3(0, -1, 0)));
  EXPECT_TRUE(pieces[3].after.isApprox(Point3(1, 0, 0)));
}

TEST(StraightBeads, TravelsPartAndPathsThatMeetJoin) {
  const Path first = through({{0, 0, 1}, {1, 0, 1}});
  const Path second = through({{1, 0, 1}, {1, 1, 1}});
  Path travel = through({{1, 0, 1}, {1, 0, 1}});
  travel.role = PathRole::Travel;
  EXPECT_FALSE(straightBeads(of({first, second}))[0].after.isZero());
  EXPECT_TRUE(straightBeads(of({first, travel, second}))[0].after.isZero());
}

TEST(StraightBeads, DropsArePoints) {
  Path drops = through({{0, 0, 0.2}, {1, 0, 0.2}, {2, 0, 0.2}});
  drops.deposit = Deposit::Drops;
  const auto pieces = straightBeads(of({drops}));
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[1].start, pieces[1].end);
}

}  // namespace
}  // namespace lamina
