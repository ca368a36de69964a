// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/contour.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "infill/contour/contour_tree.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/fill_requests.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::requestOf;
using test::reversed;

InfillRequest solid(ContourLink link = ContourLink::Average, std::size_t layer = 0) {
  InfillRequest request = requestOf(0.4, 0.0);
  request.layer = layer;
  request.settings.contour.link = link;
  return request;
}

/// Contours of circles and squares with no, one and two islands [Guacheta2021, figures 3-6 to 3-9].
std::vector<Region> outlinesWithIslands() {
  const Polygon round = circle({0, 0}, 10, 120);
  const Polygon square = rectangle(-10, -10, 10, 10);
  const Polygon round_island = reversed(circle({-4, 0}, 2.5, 60));
  const Polygon square_island = reversed(rectangle(2, -2, 5, 3));
  return {{round, {}},
          {square, {}},
          {round, {round_island}},
          {square, {round_island}},
          {round, {round_island, square_island}},
          {square, {square_island, round_island}}};
}

/// What a closed run fills [mm²].
double filledArea(const FillPath& run) {
  double sum = 0.0;
  for (std::size_t i = 0, j = run.points.size() - 1; i < run.points.size(); j = i++)
    sum += (run.points[i] - run.points[j]).norm() * run.width_mm[i];
  return sum;
}

// The outline, larger or smaller about the origin.
Polygon scaledAboutOrigin(Polygon polygon, double factor) {
  for (Point2& point : polygon) point *= factor;
  return polygon;
}

TEST(Contour, JoinsEachRegionIntoOneClosedCycle) {
  for (const Region& region : outlinesWithIslands())
    for (const ContourLink link : {ContourLink::Average, ContourLink::Tangential})
      for (std::size_t layer = 0; layer < 20; ++layer) {
        const std::vector<FillPath> joined_loops = contour({region}, solid(link, layer));
        ASSERT_EQ(joined_loops.size(), 1U)
            << "layer " << layer << ", " << region.outer.size() << " points, " << region.holes.size()
            << " islands, link " << static_cast<int>(link);
        EXPECT_TRUE(joined_loops.front().is_closed);
      }
}

TEST(Contour, LaysAsMuchAsTheRegionHolds) {
  for (const Region& region : outlinesWithIslands()) {
    double filled = 0.0;
    for (const FillPath& joined_loop : contour({region}, solid())) filled += filledArea(joined_loop);
    EXPECT_NEAR(filled / area({region}), 1.0, 0.01);
  }
}

/// Where a closed run lays something: each edge as wide as its bead, with square ends half as long.
std::vector<Polygon> beadsOf(const FillPath& run) {
  std::vector<Polygon> beads;
  for (std::size_t i = 0, j = run.points.size() - 1; i < run.points.size(); j = i++) {
    const Point2 along = (run.points[i] - run.points[j]).normalized() * 0.5 * run.width_mm[i];
    const Point2 aside(-along.y(), along.x());
    beads.push_back({run.points[j] - along - aside, run.points[i] + along - aside,
                     run.points[i] + along + aside, run.points[j] - along + aside});
  }
  return beads;
}

TEST(Contour, LeavesNoGapWhereANarrowPlaceIsWideAtOneEnd) {
  // A loop along the border, 0.5 mm wide as at the wide end, finds no centre line in the 0.4 mm of the rest,
  // which are 2.4 mm2.
  const Polygon bottle = {{0, -0.5}, {2, -0.5}, {4, -0.2}, {10, -0.2},
                          {10, 0.2}, {4, 0.2},  {2, 0.5},  {0, 0.5}};
  std::vector<Polygon> beads;
  for (const FillPath& run : contour({{bottle, {}}}, solid()))
    for (Polygon& bead : beadsOf(run)) beads.push_back(std::move(bead));
  for (const Region& open : difference({{bottle, {}}}, unite(beads))) EXPECT_LT(area({open}), 0.05);
}

TEST(Contour, LinksNothingAcrossAHole) {
  // The loop between both stars is one or two beads wide: the nearest loops may lie on the hole's other side.
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const Polygon hole = test::star(random, {0, 0}, 1.0, 3.0, 12);
    const Regions loop = unite({test::star(random, {0, 0}, 5.0, 12.0, 24), test::reversed(hole)});
    const Polygon core = scaledAboutOrigin(hole, 0.7);
    for (const FillPath& path : contour(loop, test::solidRequestOf(2.0, 0.0)))
      for (std::size_t i = 0; i + (path.is_closed ? 0 : 1) < path.points.size(); ++i) {
        const Point2& a = path.points[i];
        const Point2& b = path.points[(i + 1) % path.points.size()];
        for (double t = 0.0; t <= 1.0; t += 0.05) ASSERT_FALSE(contains({core}, a + t * (b - a))) << seed;
      }
  }
}

TEST(Contour, CutsAtPlacesThatChangeWithTheLayerOnly) {
  const Regions square = {{rectangle(0, 0, 20, 20), {}}};
  EXPECT_EQ(contour(square, solid()).front().points, contour(square, solid()).front().points);
  EXPECT_NE(contour(square, solid()).front().points,
            contour(square, solid(ContourLink::Average, 1)).front().points);
}

// [Guacheta2021, figure 3-7]
TEST(ContourTree, HasLoopsAPitchApartWithinOnePercent) {
  const ContourTree tree = contourTree({circle({0, 0}, 10, 360), {}}, solid());
  for (std::size_t i = 0; i < 24; ++i) {
    const double expected = 10.0 - 0.2 - 0.4 * static_cast<double>(i);
    for (const Point2& point : tree.loops[i].points) EXPECT_NEAR(point.norm(), expected, 0.004);
  }
}

/// Points along a loop every tenth of a pitch but beside its corners, where parallels run apart: at a turn of
/// 15 degrees by 0.9 %.
std::vector<Point2> straightPlaces(const Polygon& loop, double pitch) {
  constexpr double kCorner = M_PI / 12.0;
  std::vector<Point2> corners;
  std::vector<Point2> places;
  const std::size_t count = loop.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point2 in = loop[i] - loop[(i + count - 1) % count];
    const Point2 out = loop[(i + 1) % count] - loop[i];
    if (std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out))) > kCorner)
      corners.push_back(loop[i]);
    const int steps = 1 + static_cast<int>(out.norm() / (0.1 * pitch));
    for (int k = 0; k < steps; ++k) places.emplace_back(loop[i] + out * k / steps);
  }
  const auto isBesideCorner = [&](const Point2& place) {
    return std::any_of(corners.begin(), corners.end(),
                       [&](const Point2& corner) { return (corner - place).norm() < 1.05 * pitch; });
  };
  places.erase(std::remove_if(places.begin(), places.end(), isBesideCorner), places.end());
  return places;
}

/// The lines that the loops of each node are parallel to: those of its parent, or the border.
std::vector<std::vector<Polygon>> linesRound(const Region& region, const ContourTree& tree) {
  std::vector<std::vector<Polygon>> loops(tree.parents.size());
  loops[0] = outlines({region});
  for (const ContourLoop& loop : tree.loops) loops[loop.node].push_back(loop.points);
  std::vector<std::vector<Polygon>> lines;
  for (const std::size_t parent : tree.parents) lines.push_back(loops[parent]);
  return lines;
}

// [Guacheta2021, figure 3-9]: never nearer, and farther only where a narrow rest between loops, which is
// filled by loops of its own, ends beside them.
TEST(ContourTree, HasLoopsAPitchApartWithinOnePercentRoundIslands) {
  constexpr double kPitch = 0.4;
  for (const Region& region : outlinesWithIslands()) {
    const ContourTree tree = openContourTree(region, solid()).tree;
    const std::vector<std::vector<Polygon>> lines = linesRound(region, tree);
    std::size_t places = 0;
    std::size_t farther = 0;
    for (const ContourLoop& loop : tree.loops) {
      const double expected = tree.parents[loop.node] == 0 ? 0.5 * kPitch : kPitch;
      for (const Point2& place : straightPlaces(loop.points, kPitch)) {
        const double distance = test::distanceToOutline(lines[loop.node], place);
        EXPECT_GT(distance, 0.99 * expected) << region.holes.size() << " islands, " << place.transpose();
        ++places;
        if (distance > 1.01 * expected) ++farther;
      }
    }
    // Loops together are as long as the area is large, by the pitch.
    EXPECT_GT(static_cast<double>(places), 0.7 * area({region}) / (kPitch * 0.1 * kPitch));
    EXPECT_LE(farther, region.holes.size() < 2 ? 0U : places / 200U) << region.holes.size() << " islands";
  }
}

// [Guacheta2021, figure 3-8]
TEST(ContourTree, MergesLoopsWhereAnIslandTouchesTheOutside) {
  // 1.6 mm are left between island and border: a loop round each, and then less than a loop needs.
  const Region region = {rectangle(-10, -10, 10, 10), {reversed(rectangle(3, -3, 8.4, 3))}};
  const ContourTree tree = contourTree(region, solid());
  std::vector<std::size_t> loops(tree.parents.size(), 0);
  for (const ContourLoop& loop : tree.loops) ++loops[loop.node];
  EXPECT_EQ(loops[1], 2U);
  EXPECT_EQ(tree.parents[2], 1U);
  EXPECT_EQ(loops[2], 1U);
  EXPECT_EQ(tree.parents[3], 1U);
  EXPECT_EQ(loops[3], 1U);
}

}  // namespace
}  // namespace lamina
