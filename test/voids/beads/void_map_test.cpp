// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/void_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;

constexpr double kVoidMapHeight = 0.2;

/// A run whose beads fill the width, as flat as the layer so that they reach no farther.
Path runOf(const Polyline& points, double width, PathRole role = PathRole::Infill) {
  Path path;
  path.role = role;
  for (const Point2& point : points) path.points.emplace_back(point.x(), point.y(), kVoidMapHeight);
  path.bead = beadOfArea(width * kVoidMapHeight, kVoidMapHeight);
  path.feed_mm_s = 10.0;
  return path;
}

Path loopOf(const Polygon& points, double width, PathRole role) {
  Path path = runOf(points, width, role);
  path.is_closed = true;
  return path;
}

ToolpathLayer layerOf(std::vector<Path> paths) {
  ToolpathLayer layer;
  layer.z_mm = kVoidMapHeight;
  layer.height_mm = kVoidMapHeight;
  layer.paths = std::move(paths);
  return layer;
}

/// The test square of 10 mm filled by lines along x, each a run of its own, from edge to edge. The lines are
/// 0.4 mm wide on the layer: plan width and reach are the same.
ToolpathLayer linesEvery(double spacing, const Point2& along) {
  ToolpathLayer layer = layerOf({});
  const Point2 across(-along.y(), along.x());
  for (double at = 0.5 * spacing; at < 10.0; at += spacing) {
    // The round ends lie outside of the square.
    const Point2 start = at * across.cwiseAbs() - 0.2 * along;
    layer.paths.push_back(runOf({start, start + 10.4 * along}, 0.4));
  }
  return layer;
}

const Regions kSquare = {{rectangle(0, 0, 10, 10), {}}};
/// How much wider than it fills a bead of 0.2 mm height is: (1 - pi / 4) h.
const double kCorners = (1.0 - M_PI / 4.0) * kVoidMapHeight;

TEST(VoidMap, OfLinesFartherApartThanTheyAreWideIsWhatLiesBetween) {
  const LayerVoids voids = findVoids(kSquare, linesEvery(0.5, {1, 0}), {});
  EXPECT_NEAR(voids.uncovered_mm2, 20 * 10 * (0.1 - kCorners), 0.5);
  const LayerVoids upright = findVoids(kSquare, linesEvery(0.5, {0, 1}), {});
  EXPECT_NEAR(upright.uncovered_mm2, 20 * 10 * (0.1 - kCorners), 0.05);
  EXPECT_EQ(upright.runs, 20U);
}

/// Area outside of the square: half discs and stubs of 0.2 mm at both ends of each line.
double ends(int lines) { return lines * 2 * (0.2 * 0.4 + M_PI * 0.04 / 2.0); }

TEST(VoidMap, OfLinesSideBySideIsEmpty) {
  const LayerVoids voids = findVoids(kSquare, linesEvery(0.4, {0, 1}), {});
  EXPECT_NEAR(voids.uncovered_mm2, 0.0, 1e-9);
  EXPECT_NEAR(voids.overfill_mm2, ends(25), 0.2);
  EXPECT_TRUE(voids.voids.empty());
}

TEST(VoidMap, OfLinesTooNearCountsTheirOverlap) {
  const LayerVoids voids = findVoids(kSquare, linesEvery(0.35, {0, 1}), {});
  EXPECT_NEAR(voids.uncovered_mm2, 0.0, 1e-9);
  // 29 lines fit, the last one 0.125 mm beyond the edge; 28 pairs overlap, the ends outside too.
  const double overlap_of_ends = 28 * 2 * (0.2 * 0.05 + 0.006);
  EXPECT_NEAR(voids.overfill_mm2, 28 * 0.05 * 10 + ends(29) + 10 * 0.125 + overlap_of_ends, 1.0);
}

TEST(VoidMap, CountsARunOverAnotherWhole) {
  const ToolpathLayer layer = layerOf({runOf({{5, 1}, {5, 9}}, 0.4), runOf({{5, 3}, {5, 5}}, 0.4)});
  EXPECT_NEAR(findVoids(kSquare, layer, {}).overfill_mm2, 2 * 0.4 + M_PI * 0.04, 0.01);
}

TEST(VoidMap, TakesABendForOnePass) {
  const ToolpathLayer layer = layerOf({runOf({{2, 2}, {8, 2}, {8, 8}}, 0.4)});
  EXPECT_NEAR(findVoids(kSquare, layer, {}).overfill_mm2, 0.0, 1e-9);
}

TEST(VoidMap, TakesTheJointOfALoopForOnePass) {
  const ToolpathLayer layer = layerOf({loopOf(rectangle(2, 2, 8, 8), 0.4, PathRole::OuterWall)});
  EXPECT_NEAR(findVoids(kSquare, layer, {}).overfill_mm2, 0.0, 1e-9);
}

TEST(VoidMap, CountsAWayBackBesideTheWayOut) {
  // Two legs 0.3 mm apart of one run overlap by 0.1 mm, but for what lies near the turn.
  const ToolpathLayer layer = layerOf({runOf({{1, 5}, {9, 5}, {9, 5.3}, {1, 5.3}}, 0.4)});
  EXPECT_NEAR(findVoids(kSquare, layer, {}).overfill_mm2, 8 * 0.1, 0.1);
}

TEST(VoidMap, CountsDepositOutsideOfTheContour) {
  const ToolpathLayer layer = layerOf({runOf({{5, 12}, {5, 15}}, 0.4), runOf({{5, 12}, {5, 15}}, 0.4)});
  EXPECT_NEAR(findVoids(kSquare, layer, {}).overfill_mm2, 2 * (3 * 0.4 + M_PI * 0.04), 0.02);
}

TEST(VoidMap, OfNoDepositIsTheWholeLayer) {
  const LayerVoids voids = findVoids(kSquare, layerOf({}), {});
  EXPECT_NEAR(voids.uncovered_mm2, 100.0, 1e-9);
  ASSERT_EQ(voids.voids.size(), 1U);
  EXPECT_NEAR(area({voids.voids[0].outline}), 100.0, 1e-6);
}

TEST(VoidMap, OfNothingIsNothing) {
  const LayerVoids voids = findVoids({}, layerOf({}), {});
  EXPECT_EQ(voids.uncovered_mm2, 0.0);
  EXPECT_EQ(voids.overfill_mm2, 0.0);
}

TEST(VoidMap, LeavesOutSkirtAndTravel) {
  const ToolpathLayer layer = layerOf(
      {runOf({{2, 2}, {8, 2}}, 0.4, PathRole::Skirt), runOf({{2, 2}, {8, 2}}, 0.0, PathRole::Travel)});
  const LayerVoids voids = findVoids(kSquare, layer, {});
  EXPECT_EQ(voids.runs, 0U);
  EXPECT_NEAR(voids.uncovered_mm2, 100.0, 1e-9);
}

TEST(VoidMap, ShowsARoundVoidAsItsOutline) {
  // A wall round a disc of 2 mm radius that nothing fills.
  const ToolpathLayer layer = layerOf({loopOf(circle({0, 0}, 2.2, 90), 0.4, PathRole::InnerWall)});
  const LayerVoids voids = findVoids({{circle({0, 0}, 2.4, 90), {}}}, layer, {});
  ASSERT_EQ(voids.voids.size(), 1U);
  const double expected = M_PI * std::pow(2.0 - 0.5 * kCorners, 2);
  EXPECT_NEAR(voids.voids[0].area_mm2, expected, 0.02 * expected);
  EXPECT_NEAR(area({voids.voids[0].outline}), expected, 0.02 * expected);
  EXPECT_EQ(voids.voids[0].kind, VoidClass::Core);
}

TEST(VoidMap, ShowsAVoidRoundAnIslandWithAHole) {
  const ToolpathLayer layer = layerOf({loopOf(rectangle(1, 1, 9, 9), 0.4, PathRole::OuterWall),
                                       loopOf(rectangle(4, 4, 6, 6), 0.4, PathRole::OuterWall)});
  const Regions ring = {{rectangle(0.8, 0.8, 9.2, 9.2), {test::reversed(rectangle(4.2, 4.2, 5.8, 5.8))}}};
  const LayerVoids voids = findVoids(ring, layer, {});
  // The rounded corners of the beads leave small voids of their own.
  const auto largest = std::max_element(voids.voids.begin(), voids.voids.end(),
                                        [](const Void& a, const Void& b) { return a.area_mm2 < b.area_mm2; });
  ASSERT_NE(largest, voids.voids.end());
  EXPECT_EQ(largest->outline.holes.size(), 1U);
  EXPECT_EQ(largest->kind, VoidClass::Meeting);
}

TEST(VoidMap, ReportsTheCornerAndTheBorderOfARaster) {
  const Regions wedge = {{{{0, 0}, {10, 0}, {10, 4}}, {}}};
  const ToolpathLayer layer = layerOf({runOf({{6, 0}, {6, 3}}, 0.4), runOf({{6.5, 0}, {6.5, 3}}, 0.4)});
  const LayerVoids voids = findVoids(wedge, layer, {});
  ASSERT_GE(voids.voids.size(), 2U);
  EXPECT_EQ(std::count_if(voids.voids.begin(), voids.voids.end(),
                          [](const Void& each) { return each.kind == VoidClass::Corner; }),
            1);
}

TEST(VoidMap, OfDropsIsWhatTheirDiscsLeave) {
  Path drops = runOf({}, 1.0);
  drops.deposit = Deposit::Drops;
  drops.bead = Bead{1.0, kVoidMapHeight};
  for (int i = 0; i < 10; ++i)
    for (int k = 0; k < 10; ++k) drops.points.emplace_back(i + 0.5, k + 0.5, kVoidMapHeight);
  const LayerVoids voids = findVoids(kSquare, layerOf({drops}), {});
  EXPECT_NEAR(voids.uncovered_mm2, 21.46, 0.2);  // 1 - pi / 4 of a square raster
  EXPECT_NEAR(voids.overfill_mm2, 0.0, 0.05);
}

TEST(VoidMap, IsTheSameForAnyShareOfTurns) {
  EXPECT_TRUE(rc::check("turned layers", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const double angle = random.uniform(0, 2 * M_PI);
    const auto turned = [&](const Point2& p) {
      return Point2(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
                    std::sin(angle) * p.x() + std::cos(angle) * p.y());
    };
    const auto each = [&](Polygon points) {
      for (Point2& point : points) point = turned(point);
      return points;
    };
    const ToolpathLayer layer = layerOf({runOf(each({{1, 1}, {9, 1.3}, {9, 1.6}, {1, 1.4}}), 0.4),
                                         loopOf(each(circle({5, 5}, 3, 40)), 0.5, PathRole::InnerWall)});
    const LayerVoids voids = findVoids({{each(rectangle(0, 0, 10, 10)), {}}}, layer, {});
    // From 0.4 to 0.3 mm apart, the legs cover a strip 0.35 mm wider than they are, and overlap by 0.05 mm.
    const double ring = 2.0 * M_PI * 3.0 * (0.5 + kCorners);
    const double legs = 8.0 * (0.35 + 0.4 + kCorners) + 0.3;
    RC_ASSERT(std::abs(voids.area_mm2 - 100.0) < 1e-6);
    RC_ASSERT(std::abs(voids.uncovered_mm2 - (100.0 - ring - legs)) < 0.3);
    RC_ASSERT(std::abs(voids.overfill_mm2 - 8.0 * 0.05) < 0.1);
  }));
}

TEST(VoidMap, RefusesSettingsOutOfRange) {
  VoidMapSettings settings;
  settings.line_spacing = 0.0;
  EXPECT_THROW(findVoids(kSquare, layerOf({}), settings), InvalidInput);
  NoProgress progress;
  EXPECT_THROW(findVoids({kSquare}, Toolpath{}, {}, progress), InvalidInput);
}

}  // namespace
}  // namespace lamina
