// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/pattern/pattern_cut.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

std::vector<Polygon> plateWithHole() {
  return {rectangle(0, 0, 10, 10), test::reversed(rectangle(4, 4, 6, 6))};
}

double piecesLength(const PatternPieces& pieces) {
  double sum = 0.0;
  for (const RunOnOutlines& piece : pieces.open) sum += length(piece.points);
  return sum;
}

TEST(PatternCut, KeepsWhatLiesInMaterialAndSaysWhereItEnds) {
  const PatternPieces pieces = cutToOutlines({{{{-1, 5}, {2, 5}, {11, 5}}}, {}}, plateWithHole());
  ASSERT_EQ(pieces.open.size(), 2U);
  EXPECT_EQ(pieces.open[0].points, (Polyline{{0, 5}, {2, 5}, {4, 5}}));
  EXPECT_EQ(pieces.open[1].points, (Polyline{{6, 5}, {10, 5}}));
  ASSERT_TRUE(pieces.open[0].first && pieces.open[0].last);
  EXPECT_EQ(pieces.open[0].first->outline, 0U);
  EXPECT_EQ(pieces.open[0].first->edge, 3U);
  EXPECT_DOUBLE_EQ(pieces.open[0].first->distance_mm, 5.0);
  EXPECT_EQ(pieces.open[0].last->outline, 1U);
}

TEST(PatternCut, KeepsALoopInsideWholeAndOpensOneThatLeaves) {
  const std::vector<Polygon> plate{rectangle(0, 0, 10, 10)};
  EXPECT_EQ(cutToOutlines({{}, {rectangle(1, 1, 3, 3)}}, plate).closed.size(), 1U);
  EXPECT_TRUE(cutToOutlines({{}, {rectangle(11, 1, 13, 3)}}, plate).closed.empty());
  for (const Polygon& loop : {rectangle(8, 2, 12, 4), rectangle(-2, 2, 2, 4)}) {
    const PatternPieces pieces = cutToOutlines({{}, {loop}}, plate);
    EXPECT_TRUE(pieces.closed.empty());
    ASSERT_EQ(pieces.open.size(), 1U);
    EXPECT_DOUBLE_EQ(length(pieces.open[0].points), 6.0);
  }
}

TEST(PatternCut, GivesNothingWithoutOutlinesOrBesideThem) {
  EXPECT_TRUE(cutToOutlines({{{{0, 0}, {1, 0}}}, {}}, {}).open.empty());
  EXPECT_TRUE(cutToOutlines({{{{-5, 20}, {15, 20}}}, {}}, plateWithHole()).open.empty());
}

TEST(PatternCut, AgreesWhereCurvesRunThroughCornersAndAlongEdges) {
  const PatternCurves curves{
      {{{-1, -1}, {11, 11}}, {{-1, 4}, {11, 4}}, {{-1, 0}, {11, 0}}, {{-2, 2}, {2, -2}}}, {}};
  const PatternPieces pieces = cutToOutlines(curves, plateWithHole());
  for (const RunOnOutlines& piece : pieces.open)
    for (const Point2& point : piece.points)
      EXPECT_TRUE(contains(plateWithHole(), point) || test::distanceToOutline(plateWithHole(), point) < 1e-6);
}

TEST(PatternCut, LeavesAsMuchAsSamplesOfTheCurveLieInside) {
  EXPECT_TRUE(rc::check("random regions and curves", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const std::vector<Polygon> borders =
        outlines(unite({test::star(random, {0, 0}, 5.0, 12.0, 24),
                        test::reversed(test::star(random, {0, 0}, 1.0, 3.0, 12))}));
    Polyline curve{{-20, random.uniform(-5, 5)}};
    for (int i = 0; i < 30; ++i) curve.emplace_back(random.uniform(-14, 14), random.uniform(-14, 14));
    curve.emplace_back(20, 0);
    double inside = 0.0;
    constexpr int kSamples = 2000;
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const Point2 along = curve[i] - curve[i - 1];
      for (int k = 0; k < kSamples; ++k)
        if (contains(borders, curve[i - 1] + (k + 0.5) / kSamples * along)) inside += along.norm() / kSamples;
    }
    const double kept = piecesLength(cutToOutlines({{curve}, {}}, borders));
    RC_ASSERT(std::abs(kept - inside) < 0.01 * inside + 0.1);
  }));
}

}  // namespace
}  // namespace lamina
