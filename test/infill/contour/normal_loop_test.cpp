// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/normal_loop.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/shapes.hpp"

namespace lamina {
namespace {

/// Spacing of the points of one layer [Flores2018, figure 40].
TEST(NormalLoop, InsertsAsManyPointsAsItsStepNeedsAndNoMore) {
  // Edges of 10 and 4 mm: ceil(10 / 3) - 1 = 3 and ceil(4 / 3) - 1 = 1 points more.
  const NormalLoop loop = withNormals(test::rectangle(0, 0, 10, 4), 3.0);
  ASSERT_EQ(loop.points.size(), 4U + 2 * 3 + 2 * 1);
  EXPECT_EQ(loop.points[1], Point2(2.5, 0));
  EXPECT_EQ(loop.points[5], Point2(10, 2));
}

TEST(NormalLoop, InsertsNoPointIntoAnEdgeOfOneStep) {
  EXPECT_EQ(withNormals(test::rectangle(0, 0, 3, 3), 3.0).points.size(), 4U);
}

TEST(NormalLoop, LeavesOutRepeatedPoints) {
  const NormalLoop loop = withNormals({{0, 0}, {4, 0}, {4, 0}, {4, 4}, {4, 4 + 1e-10}, {0, 0}}, 10.0);
  EXPECT_EQ(loop.points.size(), 3U);
}

TEST(NormalLoop, PointsInwardsBetweenTheNormalsOfBothEdges) {
  const NormalLoop loop = withNormals(test::rectangle(0, 0, 10, 10), 5.0);
  EXPECT_LT((loop.inward[0] - Point2(1, 1).normalized()).norm(), 1e-12);
  EXPECT_LT((loop.inward[1] - Point2(0, 1)).norm(), 1e-12) << "half way between two corners";
}

TEST(NormalLoop, OfAHolePointsIntoTheMaterial) {
  const NormalLoop hole = withNormals(test::reversed(test::circle({0, 0}, 10, 360)), 1.0);
  for (const Point2& point : movedInwards(hole, 2.0)) EXPECT_NEAR(point.norm(), 12.0, 1e-3);
}

TEST(NormalLoop, KeepsToTheOutlineWithStepsThatAreShortEnough) {
  EXPECT_TRUE(rc::check("random outlines", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Polygon outline = test::star(random, {0, 0}, 2.0, 9.0, 15);
    const double step = random.uniform(0.1, 4.0);
    const NormalLoop loop = withNormals(outline, step);
    RC_ASSERT(loop.points.size() == loop.inward.size());
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const Point2& next = loop.points[(i + 1) % loop.points.size()];
      RC_ASSERT((next - loop.points[i]).norm() <= step * (1.0 + 1e-6));
      RC_ASSERT(test::distanceToOutline({outline}, loop.points[i]) < 1e-9);
      RC_ASSERT(std::abs(loop.inward[i].norm() - 1.0) < 1e-9);
    }
  }));
}

TEST(NormalLoop, OfFewerThanThreePointsIsEmpty) {
  EXPECT_TRUE(withNormals({{0, 0}, {1, 0}, {1, 0}}, 1.0).points.empty());
}

}  // namespace
}  // namespace lamina
