// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour.hpp"

#include <gtest/gtest.h>

#include "infill/contour_tree.hpp"
#include "lamina/geometry/offset.hpp"
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

/// Contours of circles and squares with no, one and two islands (T5).
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

// T5 of the curved paths.
TEST(Contour, JoinsEachRegionIntoOneClosedCycle) {
  for (const Region& region : outlinesWithIslands())
    for (const ContourLink link : {ContourLink::Average, ContourLink::Tangential})
      for (std::size_t layer = 0; layer < 20; ++layer) {
        const std::vector<FillPath> cycles = contour({region}, solid(link, layer));
        ASSERT_EQ(cycles.size(), 1U) << "layer " << layer << ", " << region.outer.size() << " points, "
                                     << region.holes.size() << " islands, link " << static_cast<int>(link);
        EXPECT_TRUE(cycles.front().is_closed);
      }
}

TEST(Contour, LaysAsMuchAsTheRegionHolds) {
  for (const Region& region : outlinesWithIslands()) {
    double filled = 0.0;
    for (const FillPath& cycle : contour({region}, solid())) filled += filledArea(cycle);
    EXPECT_NEAR(filled / area({region}), 1.0, 0.01);
  }
}

TEST(Contour, CutsAtPlacesThatChangeWithTheLayerOnly) {
  const Regions square = {{rectangle(0, 0, 20, 20), {}}};
  EXPECT_EQ(contour(square, solid()).front().points, contour(square, solid()).front().points);
  EXPECT_NE(contour(square, solid()).front().points,
            contour(square, solid(ContourLink::Average, 1)).front().points);
}

// T5 of the curved paths.
TEST(ContourTree, HasLoopsAPitchApartWithinOnePercent) {
  const ContourTree tree = contourTree({circle({0, 0}, 10, 360), {}}, solid());
  for (std::size_t i = 0; i < 24; ++i) {
    const double expected = 10.0 - 0.2 - 0.4 * static_cast<double>(i);
    for (const Point2& point : tree.loops[i].points) EXPECT_NEAR(point.norm(), expected, 0.004);
  }
}

// T5 of the curved paths.
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
