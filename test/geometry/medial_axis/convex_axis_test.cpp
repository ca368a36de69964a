// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/medial_axis/convex_axis.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/geometry/polygon/convex_hull.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::reversed;

double length(const MedialAxis& axis) {
  double sum = 0.0;
  for (const AxisBranch& branch : axis.branches)
    for (std::size_t i = 1; i < branch.points.size(); ++i)
      sum += (branch.points[i].point - branch.points[i - 1].point).norm();
  return sum;
}

AxisPoint deepest(const MedialAxis& axis) {
  AxisPoint found;
  for (const AxisPoint& node : axis.nodes)
    if (node.radius_mm > found.radius_mm) found = node;
  return found;
}

TEST(ConvexAxis, OfATriangleMeetsInItsIncentre) {
  const auto axis = convexAxis({{{0, 0}, {4, 0}, {0, 3}}, {}});  // sides 3, 4, 5: inradius 1
  ASSERT_TRUE(axis);
  EXPECT_EQ(axis->branches.size(), 3U);
  EXPECT_NEAR((deepest(*axis).point - Point2(1, 1)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(deepest(*axis).radius_mm, 1.0, 1e-12);
}

TEST(ConvexAxis, OfARectangleIsItsMiddleLineAndFourBisectors) {
  const auto axis = convexAxis({rectangle(0, 0, 10, 4), {}});
  ASSERT_TRUE(axis);
  EXPECT_EQ(axis->nodes.size(), 6U);
  EXPECT_EQ(axis->branches.size(), 5U);
  EXPECT_NEAR(length(*axis), 6.0 + 4.0 * 2.0 * std::sqrt(2.0), 1e-9);
}

TEST(ConvexAxis, OfARegularOutlineHasOneNodeInside) {
  for (int sides = 3; sides <= 12; ++sides) {
    const auto axis = convexAxis({circle({2, -7}, 3.0, sides), {}});
    ASSERT_TRUE(axis);
    EXPECT_EQ(axis->nodes.size(), sides + 1U) << sides << " sides";
    EXPECT_EQ(axis->branches.size(), static_cast<std::size_t>(sides));
    EXPECT_NEAR(length(*axis), 3.0 * sides, 1e-6);
  }
}

TEST(ConvexAxis, LeavesOtherRegionsToTheVoronoiDiagram) {
  const Polygon square = rectangle(0, 0, 9, 9);
  EXPECT_FALSE(convexAxis({square, {reversed(rectangle(3, 3, 4, 4))}})) << "a hole";
  EXPECT_FALSE(convexAxis({{{0, 0}, {9, 0}, {2, 2}, {0, 9}}, {}})) << "a reflex corner";
  EXPECT_FALSE(convexAxis({{{0, 0}, {5, 0}, {9, 0}, {9, 9}}, {}})) << "a corner that is none";
  EXPECT_FALSE(convexAxis({reversed(square), {}})) << "wound the other way";
  EXPECT_FALSE(convexAxis({circle({0, 0}, 9, 13), {}})) << "many corners";
  EXPECT_FALSE(convexAxis({{}, {}})) << "nothing";
  Polygon pentagram;
  for (int i = 0; i < 5; ++i) pentagram.push_back(circle({0, 0}, 9, 5)[2 * i % 5]);
  EXPECT_FALSE(convexAxis({pentagram, {}})) << "twice round";
}

/// Number of the outline's edges that are nearest to the point.
int nearestEdges(const Polygon& outline, const Point2& point) {
  const double nearest = test::distanceToOutline({outline}, point);
  int count = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Polygon edge = {outline[i], outline[(i + 1) % outline.size()]};
    count += test::distanceToOutline({edge}, point) < nearest + 1e-6 ? 1 : 0;
  }
  return count;
}

// A tree of such points with an end in each corner: no part of the axis can be missing.
TEST(ConvexAxis, IsATreeOfPointsWithTwoNearestEdgesAndEndsInEachCorner) {
  int tried = 0;
  int drawn = 0;
  const auto holds = [&] {
    ++tried;
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    Polygon points;
    for (int i = *rc::gen::inRange(3, 12); i > 0; --i)
      points.emplace_back(random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0));
    const Polygon outline = convexHull(points);
    const auto axis = convexAxis({outline, {}});
    if (!axis) return;
    ++drawn;
    RC_ASSERT(axis->nodes.size() == axis->branches.size() + 1);
    std::size_t corners = 0;
    for (const AxisPoint& node : axis->nodes) corners += node.radius_mm == 0.0 ? 1 : 0;
    RC_ASSERT(corners == outline.size());
    for (const AxisBranch& branch : axis->branches) {
      ASSERT_EQ(branch.points.size(), 2U);
      const AxisPoint& a = branch.points.front();
      const AxisPoint& b = branch.points.back();
      const Point2 middle = 0.5 * (a.point + b.point);
      RC_ASSERT(nearestEdges(outline, middle) >= 2);
      const double radius = 0.5 * (a.radius_mm + b.radius_mm);
      RC_ASSERT(std::abs(radius - test::distanceToOutline({outline}, middle)) < 1e-6);
    }
  };
  EXPECT_TRUE(rc::check("of a convex outline", holds));
  EXPECT_GT(2 * drawn, tried) << "or the property says nothing";
}

}  // namespace
}  // namespace lamina
