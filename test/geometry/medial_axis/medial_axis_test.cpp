// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/medial_axis/medial_axis.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::reversed;

/// Points are read from a grid of 1e-5 mm [mm].
constexpr double kGrid = 5e-5;

double medialAxisLength(const AxisBranch& branch) {
  double sum = 0.0;
  for (std::size_t i = 1; i < branch.points.size(); ++i)
    sum += (branch.points[i].point - branch.points[i - 1].point).norm();
  return sum;
}

double medialAxisLength(const MedialAxis& axis) {
  double sum = 0.0;
  for (const AxisBranch& branch : axis.branches) sum += medialAxisLength(branch);
  return sum;
}

void expectRadiiAreClearances(const MedialAxis& axis, const Region& region, double tolerance) {
  const std::vector<Polygon> borders = outlines({region});
  for (const AxisBranch& branch : axis.branches)
    for (const AxisPoint& each : branch.points)
      EXPECT_NEAR(each.radius_mm, test::distanceToOutline(borders, each.point), tolerance);
}

TEST(MedialAxis, OfARectangleIsItsMiddleLineAndFourBisectors) {
  const Region region = {rectangle(0, 0, 10, 4), {}};
  const MedialAxis axis = medialAxis(region);
  EXPECT_EQ(axis.nodes.size(), 6U);
  EXPECT_EQ(axis.branches.size(), 5U);
  EXPECT_NEAR(medialAxisLength(axis), 6.0 + 4.0 * 2.0 * std::sqrt(2.0), kGrid);
  expectRadiiAreClearances(axis, region, kGrid);
}

TEST(MedialAxis, OfATriangleMeetsInItsIncentre) {
  const Region region = {{{0, 0}, {4, 0}, {0, 3}}, {}};  // sides 3, 4, 5: inradius 1
  const MedialAxis axis = medialAxis(region);
  ASSERT_EQ(axis.branches.size(), 3U);
  const auto centre = std::find_if(axis.nodes.begin(), axis.nodes.end(),
                                   [](const AxisPoint& node) { return node.radius_mm > 0.5; });
  ASSERT_NE(centre, axis.nodes.end());
  EXPECT_NEAR((centre->point - Point2(1, 1)).norm(), 0.0, kGrid);
  EXPECT_NEAR(centre->radius_mm, 1.0, kGrid);
}

TEST(MedialAxis, OfASquareRingIsTheSquareBetweenAndItsCorners) {
  const Region region = {rectangle(0, 0, 10, 10), {reversed(rectangle(2, 2, 8, 8))}};
  const MedialAxis axis = medialAxis(region, 0.001);
  // From (0, 0) the axis runs along the bisector to (t, t), as far from the edges as from (2, 2).
  const double t = 2.0 * std::sqrt(2.0) / (1.0 + std::sqrt(2.0));
  double widest = 0.0;
  for (const AxisPoint& node : axis.nodes) widest = std::max(widest, node.radius_mm);
  EXPECT_NEAR(widest, t, kGrid);
  expectRadiiAreClearances(axis, region, 2e-3);
  EXPECT_EQ(pruned(axis, {1.0}).branches.size(), 1U);
}

TEST(MedialAxis, NearACornerFollowsTheParabola) {
  // Between the edge y = 0 and the corner (0, 1) of the wedge above it: y = (x² + 1) / 2.
  const Region region = {{{-3, 0}, {3, 0}, {3, 4}, {1, 4}, {0, 1}, {-1, 4}, {-3, 4}}, {}};
  const double tolerance = 1e-3;
  const MedialAxis axis = medialAxis(region, tolerance);
  int found = 0;
  for (const AxisBranch& branch : axis.branches) {
    for (const AxisPoint& each : branch.points) {
      if (std::abs(each.point.x()) > 0.5 || each.point.y() > 1.0) continue;
      EXPECT_NEAR(each.point.y(), 0.5 * (each.point.x() * each.point.x() + 1.0), kGrid);
      ++found;
    }
  }
  EXPECT_GT(found, 4);
}

TEST(MedialAxis, OfADiscPrunesToItsCentre) {
  const MedialAxis axis = pruned(medialAxis({circle({3, 4}, 2.0, 60), {}}), {0.1});
  ASSERT_EQ(axis.branches.size(), 1U);
  for (const AxisPoint& each : axis.branches[0].points) {
    EXPECT_NEAR((each.point - Point2(3, 4)).norm(), 0.0, kGrid);
    EXPECT_NEAR(each.radius_mm, 2.0 * std::cos(M_PI / 60), kGrid);
  }
}

TEST(MedialAxis, OfASlotPrunesToTheLineBetweenItsEnds) {
  const MedialAxis axis = pruned(medialAxis({rectangle(0, 0, 10, 1), {}}), {0.3});
  ASSERT_EQ(axis.branches.size(), 1U);
  EXPECT_NEAR(medialAxisLength(axis), 9.0, kGrid);
}

TEST(MedialAxis, KeepsSharpCornersWhenPruned) {
  const Region wedge = {{{0, 0}, {10, -1}, {10, 1}}, {}};
  const MedialAxis axis = pruned(medialAxis(wedge), {0.5});
  ASSERT_EQ(axis.branches.size(), 1U);
  const bool starts_at_tip = axis.branches[0].points.front().radius_mm < kGrid;
  const bool ends_at_tip = axis.branches[0].points.back().radius_mm < kGrid;
  EXPECT_TRUE(starts_at_tip != ends_at_tip);
}

TEST(FarthestWay, ThroughASquareIsADiagonal) {
  const MedialAxis way = farthestWay(medialAxis({rectangle(0, 0, 3, 3), {}}));
  ASSERT_EQ(way.branches.size(), 1U);
  EXPECT_NEAR(medialAxisLength(way), 3.0 * std::sqrt(2.0), kGrid);
}

TEST(FarthestWay, ThroughADiscIsADiameter) {
  const MedialAxis way = farthestWay(medialAxis({circle({3, 4}, 2.0, 60), {}}));
  ASSERT_EQ(way.branches.size(), 1U);
  const std::vector<AxisPoint>& points = way.branches[0].points;
  EXPECT_NEAR((points.front().point - points.back().point).norm(), 4.0, kGrid);
}

TEST(FarthestWay, ThroughARectangleGoesFromCornerToOppositeCorner) {
  const MedialAxis way = farthestWay(medialAxis({rectangle(0, 0, 10, 2), {}}));
  ASSERT_EQ(way.branches.size(), 1U);
  EXPECT_NEAR(medialAxisLength(way), 8.0 + 2.0 * std::sqrt(2.0), kGrid);
}

TEST(FarthestWay, OfARingWithoutTipsIsTheRing) {
  const MedialAxis ring =
      pruned(medialAxis({circle({0, 0}, 2.0, 60), {reversed(circle({0, 0}, 1.0, 60))}}), {0.1});
  EXPECT_NEAR(medialAxisLength(farthestWay(ring)), medialAxisLength(ring), 1e-12);
}

TEST(MedialAxis, OfWhatHasNoAreaIsEmpty) {
  EXPECT_TRUE(medialAxis({}).branches.empty());
  EXPECT_TRUE(medialAxis({{{1, 1}}, {}}).branches.empty());
  EXPECT_TRUE(medialAxis({{{0, 0}, {1, 1}}, {}}).branches.empty());
  EXPECT_TRUE(medialAxis({{{0, 0}, {1, 0}, {2, 0}}, {}}).branches.empty());
  EXPECT_TRUE(medialAxis({{{0, 0}, {1e-7, 0}, {0, 1e-7}}, {}}).branches.empty());
}

TEST(MedialAxis, RefusesAToleranceOfNothing) {
  EXPECT_THROW(medialAxis({rectangle(0, 0, 1, 1), {}}, 0.0), InvalidInput);
}

TEST(MedialAxis, HasRadiiThatAreClearancesAndStaysInside) {
  EXPECT_TRUE(rc::check("random regions", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions regions = unite(
        {test::star(random, {0, 0}, 3.0, 12.0, 24), reversed(test::star(random, {0, 0}, 1.0, 3.0, 12))});
    for (const Region& region : regions) {
      const std::vector<Polygon> borders = outlines({region});
      const MedialAxis axis = medialAxis(region);
      RC_ASSERT(!axis.branches.empty());
      for (const AxisBranch& branch : axis.branches) {
        RC_ASSERT(branch.points.size() >= 2U);
        for (const AxisPoint& each : branch.points) {
          const double clearance = test::distanceToOutline(borders, each.point);
          RC_ASSERT(std::abs(each.radius_mm - clearance) < 1e-4);
          RC_ASSERT(clearance < 1e-4 || contains(borders, each.point));
        }
      }
    }
  }));
}

TEST(MedialAxis, ReachesEveryLargestDisc) {
  EXPECT_TRUE(rc::check("random points", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Region region = {test::star(random, {0, 0}, 4.0, 8.0, 16), {}};
    const MedialAxis axis = medialAxis(region);
    // A point lies on the way from the border to the axis: the axis' discs cover the region.
    const Point2 point(random.uniform(-2.7, 2.7), random.uniform(-2.7, 2.7));  // of the disc in every star
    double deepest = 0.0;
    for (const AxisBranch& branch : axis.branches)
      for (std::size_t i = 1; i < branch.points.size(); ++i)
        for (int k = 0; k <= 20; ++k) {
          const AxisPoint& a = branch.points[i - 1];
          const AxisPoint& b = branch.points[i];
          const double t = k / 20.0;
          deepest = std::max(deepest, (1 - t) * a.radius_mm + t * b.radius_mm -
                                          (a.point + t * (b.point - a.point) - point).norm());
        }
    RC_ASSERT(deepest > 0.0);
  }));
}

TEST(MedialAxis, TakesOutlinesThatTouchAndCrossAsTheyLie) {
  EXPECT_TRUE(rc::check("random points on a coarse grid", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    Region region;
    for (int i = 0; i < 12; ++i)
      region.outer.emplace_back(std::floor(random.uniform(0, 6)), std::floor(random.uniform(0, 6)));
    for (const AxisBranch& branch : pruned(medialAxis(region), {0.1}).branches)
      for (const AxisPoint& each : branch.points) {
        RC_ASSERT(each.radius_mm >= 0.0);
        RC_ASSERT((each.point.array() >= -kGrid).all() && (each.point.array() <= 5.0 + kGrid).all());
      }
  }));
}

}  // namespace
}  // namespace lamina
