// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/void_points.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/drop_lattices.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::hexLattice;
using test::hexSite;
using test::rectangle;
using test::squareLattice;
using test::without;

std::vector<VoidPoint> voronoi(const std::vector<Point2>& drops, double least_distance) {
  return findVoidPoints(VoidDetector::Voronoi, drops, {1.0, least_distance});
}

TEST(VoronoiPoints, OfASquareLatticeAreTheMiddlesOfItsCells) {
  const std::vector<VoidPoint> points = voronoi(squareLattice(9), 0.0);
  EXPECT_EQ(points.size(), 64U);
  for (const VoidPoint& point : points) EXPECT_NEAR(point.clearance_mm, std::sqrt(0.5), 1e-9);
  EXPECT_TRUE(voronoi(squareLattice(9), 0.71).empty());
}

TEST(VoronoiPoints, OfAHexagonalLatticeAreEquallyClear) {
  const std::vector<VoidPoint> points = inside({rectangle(-5, -5, 5, 5)}, voronoi(hexLattice(7.0), 0.0));
  EXPECT_GT(points.size(), 150U);
  for (const VoidPoint& point : points) EXPECT_NEAR(point.clearance_mm, 1.0 / std::sqrt(3.0), 1e-9);
}

TEST(VoronoiPoints, OfAMissingTriangleHaveTheirGreatestClearanceInItsMiddle) {
  const std::vector<Point2> removed = {hexSite(0, 0), hexSite(1, 0), hexSite(0, 1)};
  double greatest = 0.0;
  for (const VoidPoint& point :
       inside({rectangle(-4, -4, 4, 4)}, voronoi(without(hexLattice(7.0), removed), 0.0)))
    greatest = std::max(greatest, point.clearance_mm);
  EXPECT_NEAR(greatest, 1.1547, 5e-5);
}

TEST(VoronoiPoints, AreAsFarFromTheNearestDropAsTheySay) {
  EXPECT_TRUE(rc::check("random drops", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    std::vector<Point2> drops;
    for (int i = 0; i < 80; ++i) drops.emplace_back(random.uniform(100, 110), random.uniform(-3, 4));
    for (const VoidPoint& point : voronoi(drops, 0.2)) {
      double nearest = 1e9;
      for (const Point2& drop : drops) nearest = std::min(nearest, (drop - point.position).norm());
      RC_ASSERT(std::abs(nearest - point.clearance_mm) < 1e-6);
    }
  }));
}

TEST(VoronoiPoints, InAWedgeOfContoursAreAsClearAsItsAngleSays) {
  // Two contours a diameter apart as nearly continuous lines: the inner one's tip is 1 / sin(half the angle)
  // further in.
  const double angles_deg[] = {60.0, 40.0, 28.96, 20.0};
  for (int k = 0; k < 4; ++k) {
    const double half = 0.5 * angles_deg[k] * M_PI / 180.0;
    const double tips_apart = 1.0 / std::sin(half);
    std::vector<Point2> drops;
    for (const double tip : {0.0, tips_apart})
      for (int i = 0; i < 4000; ++i)
        for (const double side : {-1.0, 1.0})
          drops.emplace_back(tip + 0.002 * i * std::cos(half), side * 0.002 * i * std::sin(half));
    double greatest = 0.0;
    for (const VoidPoint& point : voronoi(drops, 0.3))
      if (std::abs(point.position.y()) < 1e-3 && point.position.x() < tips_apart)
        greatest = std::max(greatest, point.clearance_mm);
    // x sin(half) from the outer legs is as far as 1 / sin(half) - x from the inner tip.
    EXPECT_NEAR(greatest, 1.0 / (1.0 + std::sin(half)), 2e-3) << angles_deg[k];
  }
}

TEST(NeighbourPoints, MarkAMissingDropFromAllItsNeighbours) {
  for (const std::vector<Point2>& lattice : {squareLattice(9), hexLattice(5.0)}) {
    const std::vector<VoidPoint> points =
        inside({rectangle(-2.5, -2.5, 2.5, 2.5)},
               findVoidPoints(VoidDetector::Neighbours, without(lattice, {{0, 0}}), {1.0, 0.8}));
    ASSERT_EQ(points.size(), 1U);
    EXPECT_LT(points[0].position.norm(), 1e-9);
    EXPECT_NEAR(points[0].clearance_mm, 1.0, 1e-9);
  }
}

class EitherDetector : public testing::TestWithParam<VoidDetector> {};

TEST_P(EitherDetector, TakesDegenerateClouds) {
  const std::vector<Point2> line = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {5, 0}};
  const std::vector<Point2> twice = {{0, 0}, {0, 0}, {1, 0}, {1, 0}, {0, 1}, {0, 1}};
  for (const std::vector<Point2>& drops :
       {std::vector<Point2>{}, {{1, 1}}, {{1, 1}, {2, 2}}, line, twice, std::vector<Point2>(7, Point2(3, 3))})
    for (const VoidPoint& point : findVoidPoints(GetParam(), drops, {1.0, 0.8}))
      EXPECT_GE(point.clearance_mm, 0.8 - 1e-6);
}

INSTANTIATE_TEST_SUITE_P(VoidPoints, EitherDetector,
                         testing::Values(VoidDetector::Voronoi, VoidDetector::Neighbours));

}  // namespace
}  // namespace lamina
