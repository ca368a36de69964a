// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/loop_graph.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

Loop loopOf(const Polygon& polygon, double width) {
  return Loop(polygon, std::vector<double>(polygon.size(), width));
}

/// Two squares of 10 and 8 mm, 1 mm apart.
LoopGraph twoSquares() {
  return LoopGraph({loopOf(rectangle(0, 0, 10, 10), 1.0), loopOf(rectangle(1, 1, 9, 9), 0.5)});
}

TEST(LoopGraph, OfRingsThatAreNotJoinedGivesEachByItself) {
  const std::vector<FillPath> lines = twoSquares().lines();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].points, rectangle(0, 0, 10, 10));
  EXPECT_EQ(lines[1].width_mm, std::vector<double>(4, 0.5));
}

TEST(LoopGraph, JoinsTwoRingsIntoOneByTwoLinks) {
  LoopGraph net = twoSquares();
  // From (4, 0) to (5, 0), and opposite from (4, 1) to (5, 1).
  net.join({0, 4.0, 5.0}, {1, 3.0, 4.0}, LinkEnds::Alike);
  const std::vector<FillPath> lines = net.lines();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(lines[0].is_closed);
  // What is cut away, 1 mm of each, is as long as both links.
  EXPECT_NEAR(perimeter(lines[0].points), 40.0 + 32.0 - 2.0 + 2.0, 1e-9);
  EXPECT_EQ(net.groupOf(1), net.groupOf(0));
}

TEST(LoopGraph, GivesLinksTheMeanWidthOfWhatTheyJoin) {
  LoopGraph net = twoSquares();
  net.join({0, 4.0, 5.0}, {1, 3.0, 4.0}, LinkEnds::Alike);
  const FillPath line = net.lines().front();
  double links = 0.0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Point2& before = line.points[i > 0 ? i - 1 : line.points.size() - 1];
    if (line.width_mm[i] == 0.75) links += (line.points[i] - before).norm();
  }
  EXPECT_NEAR(links, 2.0, 1e-9);
}

TEST(LoopGraph, KeepsGapsApart) {
  LoopGraph net = twoSquares();
  net.join({0, 4.0, 5.0}, {1, 3.0, 4.0}, LinkEnds::Alike);
  EXPECT_FALSE(net.isFree({0, 4.5, 4.7}, 0.0));
  EXPECT_FALSE(net.isFree({0, 3.0, 6.0}, 0.0));
  EXPECT_FALSE(net.isFree({0, 5.5, 6.5}, 1.0));
  EXPECT_TRUE(net.isFree({0, 6.5, 7.5}, 1.0));
  EXPECT_FALSE(net.isFree({0, 39.5, 44.5}, 0.0));
  EXPECT_TRUE(net.isFree({0, 39.5, 41.5}, 1.0));
}

TEST(LoopGraph, ChainsRingsIntoOneOpenLine) {
  LoopGraph net = twoSquares();
  net.chain({{0, 4.0, 5.0}, {1, 2.0, 3.0}});
  const std::vector<FillPath> lines = net.lines();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_FALSE(lines[0].is_closed);
  EXPECT_TRUE(lines[0].points.front().isApprox(Point2(5, 0)));
  EXPECT_TRUE(lines[0].points.back().isApprox(Point2(3, 1)));
  EXPECT_NEAR(length(lines[0].points), 39.0 + 1.0 + 31.0, 1e-9);
}

}  // namespace
}  // namespace lamina
