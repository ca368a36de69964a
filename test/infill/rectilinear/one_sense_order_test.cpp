// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/one_sense_order.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>

#include "infill/rectilinear/raster.hpp"
#include "infill/rectilinear/variable_width_runs.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

std::vector<RasterRow> rowsOf(const Regions& regions, double spacing_mm) {
  const Raster raster = rasterise(regions, spacing_mm, RasterFrame(0.0));
  std::vector<RasterRow> rows;
  for (std::size_t i = 0; i + 1 < raster.sorted.size(); i += 2) {
    const Crossing& left = raster.crossings[raster.sorted[i]];
    rows.push_back({left.line, left.x, raster.crossings[raster.sorted[i + 1]].x});
  }
  return rows;
}

bool liesAbove(const RasterRow& upper, const RasterRow& lower) {
  return upper.line == lower.line + 1 && upper.left_mm < lower.right_mm && lower.left_mm < upper.right_mm;
}

/// Random stars with random holes.
Regions holedRegions(Random& random) {
  std::vector<Polygon> outlines = {test::star(random, {0, 0}, 5.0, 14.0, 30),
                                   test::star(random, {28, 3}, 2.0, 8.0, 9)};
  for (std::size_t i = random.below(4); i > 0; --i)
    outlines.push_back(
        test::reversed(test::star(random, {random.uniform(-6, 6), random.uniform(-6, 6)}, 0.5, 2.5, 8)));
  return unite(outlines);
}

TEST(OneSenseOrder, LaysNoRowBetweenTwoDepositedBeforeIt) {
  EXPECT_TRUE(rc::check("random polygons with holes", [](std::uint64_t seed) {
    Random random(seed);
    const double spacing_mm = random.uniform(0.2, 1.5);
    const std::vector<RasterRow> rows = rowsOf(holedRegions(random), spacing_mm);
    const Point2 from(random.uniform(-20, 40), random.uniform(-20, 20));
    const std::vector<RowVisit> order = orderInOneSense(rows, {spacing_mm, 0.0}, from);
    RC_ASSERT(order.size() == rows.size());
    std::vector<bool> is_deposited(rows.size(), false);
    for (const RowVisit& visit : order) {
      RC_ASSERT(!is_deposited[visit.row]);
      for (std::size_t other = 0; other < rows.size(); ++other) {
        RC_ASSERT(!(is_deposited[other] && liesAbove(rows[other], rows[visit.row])));
        RC_ASSERT(is_deposited[other] || !liesAbove(rows[visit.row], rows[other]));
      }
      is_deposited[visit.row] = true;
    }
  }));
}

TEST(OneSenseOrder, GoesToAndFroInAChain) {
  const std::vector<RasterRow> rows = rowsOf({{rectangle(0, 0.5, 10, 4.5), {}}}, 1.0);
  const std::vector<RowVisit> order = orderInOneSense(rows, {1.0, 0.0}, {11.0, 0.0});
  ASSERT_EQ(order.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(order[i].row, i);
    EXPECT_EQ(order[i].enters_right, i % 2 == 0) << "from the right, where the nozzle is";
  }
}

TEST(OneSenseOrder, LaysBothLegsBeforeWhatJoinsThem) {
  // A gate: legs of 5 rows each, and a lintel of 2 rows.
  const std::vector<RasterRow> rows =
      rowsOf({{{{0, 0.5}, {3, 0.5}, {3, 5.5}, {7, 5.5}, {7, 0.5}, {10, 0.5}, {10, 7.5}, {0, 7.5}}, {}}}, 1.0);
  ASSERT_EQ(rows.size(), 12U);
  const std::vector<RowVisit> order = orderInOneSense(rows, {1.0, 0.0}, {10.0, 0.0});
  for (std::size_t i = 0; i < 5; ++i) EXPECT_GT(rows[order[i].row].left_mm, 5.0) << "the nearer leg first";
  for (std::size_t i = 5; i < 10; ++i) EXPECT_LT(rows[order[i].row].right_mm, 5.0);
  EXPECT_EQ(order[10].row, 10U);
  EXPECT_EQ(order[11].row, 11U);
}

TEST(OneSenseOrder, OfNothingIsEmpty) { EXPECT_TRUE(orderInOneSense({}, {0.4, 0.0}, {0, 0}).empty()); }

/// A bead along the raster.
struct DepositedRow {
  double left_mm;
  double right_mm;
  double height_mm;  ///< of its middle, across
};

std::vector<DepositedRow> depositedRows(const std::vector<FillPath>& runs, const RasterFrame& frame,
                                        double pitch_mm) {
  std::vector<DepositedRow> rows;
  for (const FillPath& run : runs)
    for (std::size_t i = 1; i < run.points.size(); ++i) {
      const Point2 a = frame.intoRaster(run.points[i - 1]);
      const Point2 b = frame.intoRaster(run.points[i]);
      if (std::abs(b.x() - a.x()) < 4.0 * pitch_mm || std::abs(b.y() - a.y()) > 0.02 * pitch_mm) continue;
      rows.push_back({std::min(a.x(), b.x()), std::max(a.x(), b.x()), 0.5 * (a.y() + b.y())});
    }
  return rows;
}

/// Beads that lie beside one deposited before them, on the side they should come from.
std::size_t depositedBelow(const std::vector<DepositedRow>& rows, double pitch_mm) {
  std::size_t count = 0;
  for (std::size_t later = 0; later < rows.size(); ++later)
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      const DepositedRow& a = rows[earlier];
      const DepositedRow& b = rows[later];
      const bool are_beside = std::min(a.right_mm, b.right_mm) - std::max(a.left_mm, b.left_mm) > pitch_mm;
      const double above = a.height_mm - b.height_mm;
      if (are_beside && above > 0.6 * pitch_mm && above < 1.4 * pitch_mm) ++count;
    }
  return count;
}

/// Rows of one sense in which one lies beside one deposited before it, on the wrong side.
std::size_t countUnordered(std::uint64_t seed) {
  Random random(seed);
  const Regions regions = holedRegions(random);
  InfillRequest request;
  request.pitch_mm = request.spacing_mm = random.uniform(0.3, 0.6);
  request.angle_rad = random.uniform(-3.0, 3.0);
  request.advance = LineAdvance::OneSense;
  const std::vector<FillPath> runs =
      variableWidthRuns(offset(regions, -0.5 * narrowestBead(request)), request);
  return depositedBelow(depositedRows(runs, RasterFrame(request.angle_rad), request.pitch_mm),
                        request.pitch_mm);
}

TEST(VariableWidthRuns, InOneSenseComeAfterWhatGoesOnUnderThemBesideAFlatBorder) {
  // Parts with a border so flat that a row goes on along it, in half its line, far beyond the end of its
  // line.
  for (const std::uint64_t seed : {1220, 2071}) EXPECT_EQ(countUnordered(seed), 0U) << seed;
}

TEST(VariableWidthRuns, InOneSenseLieAboveThoseDepositedBefore) {
  std::size_t unordered = 0;
  EXPECT_TRUE(rc::check("random polygons with holes", [&unordered](std::uint64_t seed) {
    Random random(seed);
    const Regions regions = holedRegions(random);
    InfillRequest request;
    request.pitch_mm = request.spacing_mm = random.uniform(0.3, 0.6);
    request.angle_rad = random.uniform(-3.0, 3.0);
    const Regions links = offset(regions, -0.5 * narrowestBead(request));
    const RasterFrame frame(request.angle_rad);
    const std::vector<FillPath> shortest = variableWidthRuns(links, request);
    unordered += depositedBelow(depositedRows(shortest, frame, request.pitch_mm), request.pitch_mm);
    request.advance = LineAdvance::OneSense;
    const std::vector<FillPath> runs = variableWidthRuns(links, request);
    RC_ASSERT(depositedBelow(depositedRows(runs, frame, request.pitch_mm), request.pitch_mm) == 0U);
    double filled = 0.0;
    for (const FillPath& run : runs)
      for (std::size_t i = 1; i < run.points.size(); ++i)
        filled += run.width_mm[i] * (run.points[i] - run.points[i - 1]).norm();
    RC_ASSERT(std::abs(filled / area(regions) - 1.0) < 0.03);
  }));
  EXPECT_GT(unordered, 0U) << "otherwise the order would need no care";
}

}  // namespace
}  // namespace lamina
