// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/hilbert/hilbert.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polygon/plane_vectors.hpp"
#include "infill/hilbert/hilbert_order.hpp"
#include "infill/hilbert/hilbert_quadtree.hpp"
#include "infill/lattice/lattice.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/fill_requests.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::requestOf;
using test::reversed;

/// Material of the paths over the height of the layer [mm²].
double plannedArea(const std::vector<FillPath>& paths, double pitch_mm) {
  double sum = 0.0;
  for (const FillPath& path : paths)
    for (std::size_t i = path.is_closed ? 0 : 1; i < path.points.size(); ++i)
      sum += (path.points[i] - path.points[(i + path.points.size() - 1) % path.points.size()]).norm() *
             (path.width_mm.empty() ? pitch_mm : path.width_mm[i]);
  return sum;
}

TEST(Hilbert, OverASquareOfAPowerOfTwoIsTheWholeCurve) {
  // 16 x 16 points at a spacing of 0.4 and 0.04 from the border of where centre lines run.
  const double side = 15 * 0.4 + 0.04 + 0.4;
  const std::vector<FillPath> paths = hilbert({{rectangle(0, 0, side, side), {}}}, requestOf(0.4, 0.0));
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_NEAR(length(paths[0].points), 255 * 0.4, 1e-6);
}

/// Pieces that the curve over a region's lattice falls into.
std::size_t piecesOfCurve(const Region& centre_lines, double spacing_mm, double angle_rad) {
  const Lattice lattice(centre_lines, spacing_mm, angle_rad);
  std::size_t pieces = 0;
  bool is_inside = false;
  for (const Cell& cell : hilbertOrder(lattice.frame.columns(), lattice.frame.rows())) {
    const bool was_inside = is_inside;
    is_inside = lattice.isInside(lattice.indexOf(cell));
    pieces += is_inside && !was_inside ? 1 : 0;
  }
  return pieces;
}

TEST(Hilbert, HasFewerRunsThanTheCurveHasPieces) {
  const Regions ring = {{circle({0, 0}, 20, 200), {reversed(circle({2, 1}, 7, 90))}}};
  const InfillRequest request = requestOf(0.8, 0.2);
  const std::size_t pieces = piecesOfCurve(offset(ring, -0.4).front(), 0.8, 0.2);
  EXPECT_GT(pieces, 20U) << "or the test says nothing";
  EXPECT_LT(hilbert(ring, request).size(), pieces);
}

TEST(Hilbert, SearchesTheAngleOfFewestRuns) {
  const Regions slanted = {{{{0, 0}, {20, 8}, {16, 18}, {-4, 10}}, {}}};
  InfillRequest request = requestOf(0.5, 0.0);
  const std::size_t given = hilbert(slanted, request).size();
  std::size_t fewest = given;
  for (int i = 1; i < 12; ++i)
    fewest = std::min(fewest, hilbert(slanted, requestOf(0.5, 0.5 * M_PI * i / 12)).size());
  EXPECT_LT(fewest, given) << "or the test says nothing";
  request.settings.hilbert.angles = 12;
  EXPECT_EQ(hilbert(slanted, request).size(), fewest);
}

TEST(HilbertQuadtree, FillsARegionInOneClosedRun) {
  const Regions ring = {{circle({0, 0}, 20, 200), {reversed(circle({2, 1}, 7, 90))}}};
  const std::vector<FillPath> paths = hilbertQuadtree(ring, requestOf(0.4, 0.2));
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_TRUE(paths[0].is_closed);
}

TEST(HilbertQuadtree, FillsEachRegionInOneRun) {
  const Regions regions = {{rectangle(0, 0, 7, 7), {}}, {rectangle(10, 0, 19, 5), {}}};
  const std::vector<FillPath> runs = hilbertQuadtree(regions, requestOf(0.4, 0.0));
  ASSERT_EQ(runs.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Box2 box = boundingBox({runs[i].points});
    const bool is_left = box.high.x() < 7.0;
    EXPECT_TRUE(is_left || box.low.x() > 10.0) << "from region to region";
    EXPECT_GT(box.high.x() - box.low.x(), is_left ? 5.0 : 7.0);
    EXPECT_GT(box.high.y() - box.low.y(), is_left ? 5.0 : 3.0);
  }
}

TEST(HilbertQuadtree, LaysTheMaterialThatASquareHolds) {
  for (const double side : {8.0, 8.1, 8.2, 8.3}) {
    const std::vector<FillPath> paths =
        hilbertQuadtree({{rectangle(0, 0, side, side), {}}}, requestOf(0.4, 0.0));
    // The lattice keeps 0.02 mm off the border of where centre lines run.
    EXPECT_NEAR(plannedArea(paths, 0.4), std::pow(side - 0.04, 2), 0.03 * side * side) << side;
  }
}

TEST(Hilbert, LaysTheMaterialThatAStripHolds) {
  // VariableWidthLines that are no whole number of pitches wide, so that cells are larger than the spacing.
  for (const double width : {4.2, 4.3, 4.4, 4.5}) {
    const std::vector<FillPath> paths = hilbert({{rectangle(0, 0, 20, width), {}}}, requestOf(0.4, 0.0));
    EXPECT_NEAR(plannedArea(paths, 0.4), (20 - 0.04) * (width - 0.04), 0.05 * 20 * width) << width;
  }
}

/// How near a run comes to the line half a pitch inside its region's border [mm].
double distanceToBorder(const FillPath& run, const Regions& regions) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Polygon& border : outlines(offset(regions, -0.2)))
    for (std::size_t k = 0; k < border.size(); ++k)
      for (const Point2& point : run.points)
        nearest = std::min(
            nearest, (nearestOnSegment(border[k], border[(k + 1) % border.size()], point) - point).norm());
  return nearest;
}

TEST(HilbertQuadtree, OfLittleDensityHoldsOnToTheBorder) {
  const Regions square = {{rectangle(0, 0, 10.4, 10.4), {}}};
  for (const double angle : {0.0, 0.3})
    for (const FillPath& run : hilbertQuadtree(square, requestOf(3.0, angle)))
      EXPECT_LE(distanceToBorder(run, square), 0.1001) << angle;
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Regions star = {{test::star(random, {0, 0}, 5.0, 12.0, 24), {}}};
    for (const FillPath& run : hilbertQuadtree(star, requestOf(2.0, 0.1 * i))) {
      EXPECT_EQ(run.points.size(), run.width_mm.size());
      EXPECT_LE(distanceToBorder(run, star), 0.1001) << i;
    }
  }
}

TEST(HilbertQuadtree, ASpurToTheBorderLaysAsMuchAsABeadOfItsLength) {
  // The corners of the run stand on a grid; the tip of the spur is 0.1 mm, a quarter of a pitch, beyond the
  // line that is 0.2 mm inside.
  const std::vector<FillPath> runs =
      hilbertQuadtree({{rectangle(0, 0, 10.4, 10.4), {}}}, requestOf(3.0, 0.0));
  ASSERT_EQ(runs.size(), 1U);
  ASSERT_TRUE(runs[0].is_closed);
  FillPath bare = runs[0];
  const auto inset = [](const Point2& p) { return std::min({p.x(), p.y(), 10.4 - p.x(), 10.4 - p.y()}); };
  const auto tip = std::min_element(bare.points.begin(), bare.points.end(),
                                    [&](const Point2& a, const Point2& b) { return inset(a) < inset(b); });
  EXPECT_NEAR(inset(*tip), 0.1, 1e-9);
  const auto at = tip - bare.points.begin();
  const Point2 foot = bare.points[at - 1];
  EXPECT_EQ(bare.points[at + 1], foot);
  bare.points.erase(tip, tip + 2);
  bare.width_mm.erase(bare.width_mm.begin() + at, bare.width_mm.begin() + at + 2);
  const double width_mm = bare.width_mm[0];
  EXPECT_NEAR(plannedArea(runs, 0.4) - plannedArea({bare}, 0.4), width_mm * (inset(foot) - 0.1), 1e-9);
}

TEST(HilbertQuadtree, OfHalfTheDensityLaysHalfTheMaterial) {
  const Regions square = {{rectangle(0, 0, 40, 40), {}}};
  EXPECT_NEAR(plannedArea(hilbertQuadtree(square, requestOf(0.8, 0.0)), 0.4), 0.5 * 40 * 40, 0.04 * 40 * 40);
}

}  // namespace
}  // namespace lamina
