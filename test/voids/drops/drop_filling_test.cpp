// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/drops/drop_filling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/voids/beads/overlap_meter.hpp"
#include "lamina/voids/drops/drop_overlap.hpp"
#include "support/drop_lattices.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::filledLayer;
using test::hexLattice;
using test::hexSite;
using test::layerWithin;
using test::rectangle;
using test::squareLattice;
using test::without;

DropVoidSettings allowing(double overlap, VoidDetector detector = VoidDetector::Voronoi) {
  DropVoidSettings settings;
  settings.overlap = overlap;
  settings.detector = detector;
  return settings;
}

std::size_t addedTo(const DropLayer& layer, double overlap) {
  return newDrops(fillDropVoids(layer, allowing(overlap))).size();
}

DropLayer squareWithout(const std::vector<Point2>& removed) {
  return layerWithin(rectangle(-4, -4, 4, 4), without(squareLattice(9), removed));
}

DropLayer hexWithout(const std::vector<Point2>& removed) {
  // The border lies on drops: between it and the lattice there shall be no place of its own.
  const double row = 0.5 * std::sqrt(3.0);
  return layerWithin(rectangle(-6, -6 * row, 6, 6 * row), without(hexLattice(9.0), removed));
}

void expectDropsAt(const std::vector<Point2>& drops, const std::vector<Point2>& places) {
  EXPECT_EQ(drops.size(), places.size());
  for (const Point2& place : places)
    EXPECT_TRUE(std::any_of(drops.begin(), drops.end(), [&](const Point2& drop) {
      return (drop - place).norm() < 1e-6;
    })) << place.transpose();
}

TEST(DropFilling, LeavesASoundSquareLatticeAloneUpToItsPores) {
  EXPECT_EQ(addedTo(squareWithout({}), 0.29), 0U);
  EXPECT_EQ(addedTo(squareWithout({}), 0.30), 64U);
}

TEST(DropFilling, LeavesASoundHexagonalLatticeAlone) {
  for (const double overlap : {0.0, 0.2, 0.42}) EXPECT_EQ(addedTo(hexWithout({}), overlap), 0U);
}

TEST(DropFilling, PutsAMissingDropBackExactly) {
  for (const double overlap : {0.0, 0.2, 0.29}) {
    const DropLayer layer = squareWithout({{1, 1}});
    const std::vector<DropVoid> voids = fillDropVoids(layer, allowing(overlap));
    ASSERT_EQ(voids.size(), 1U);
    expectDropsAt(voids[0].drops, {{1, 1}});
    EXPECT_NEAR(measureOverlap(layer.drops, voids[0].drops, 1.0).greatest_linear, 0.0, 1e-9);
  }
}

TEST(DropFilling, PutsMissingDropsOfAHexagonalLatticeBack) {
  const std::vector<std::vector<Point2>> cases = {
      {hexSite(0, 0)},
      {hexSite(0, 0), hexSite(1, 0)},
      {hexSite(-1, 0), hexSite(0, 0), hexSite(1, 0)},
      {hexSite(0, 0), hexSite(1, 0), hexSite(0, 1)},
  };
  for (const std::vector<Point2>& removed : cases)
    for (const double overlap : {0.0, 0.1, 0.2, 0.3}) {
      const std::vector<DropVoid> voids = fillDropVoids(hexWithout(removed), allowing(overlap));
      ASSERT_EQ(voids.size(), 1U) << removed.size() << " missing, overlap " << overlap;
      expectDropsAt(voids[0].drops, removed);
    }
}

TEST(DropFilling, FillsVoidsApartFromEachOther) {
  const std::vector<DropVoid> voids =
      fillDropVoids(hexWithout({hexSite(-2, 0), hexSite(2, 0)}), allowing(0.2));
  ASSERT_EQ(voids.size(), 2U);
  expectDropsAt(voids[0].drops, {hexSite(-2, 0)});
  expectDropsAt(voids[1].drops, {hexSite(2, 0)});
}

TEST(DropFilling, ReportsHowMuchOfAVoidItCovered) {
  const std::vector<DropVoid> hex = fillDropVoids(hexWithout({{0, 0}}), allowing(0.0));
  ASSERT_EQ(hex.size(), 1U);
  EXPECT_NEAR(hex[0].uncovered_before_mm2, 1.0273, 0.02);
  EXPECT_NEAR(hex[0].uncovered_after_mm2, 6 * 0.0403, 0.02) << "six pores round the new drop";
  const std::vector<DropVoid> square = fillDropVoids(squareWithout({{0, 0}}), allowing(0.0));
  ASSERT_EQ(square.size(), 1U);
  EXPECT_LT(square[0].uncovered_before_mm2, 1.6438) << "what lies within a diameter of its middle";
  EXPECT_NEAR(square[0].greatest_clearance_mm, 1.0, 1e-9);
}

/// Two rows of 21 drops, the upper one shifted.
DropLayer twoRows(double height, double shift) {
  std::vector<Point2> drops;
  for (int i = 0; i <= 20; ++i) drops.emplace_back(i, 0);
  for (int i = 20; i >= 0; --i) drops.emplace_back(i + shift, height);
  DropLayer layer;
  layer.diameter_mm = 1.0;
  layer.drops = drops;
  layer.chains = {{DropRole::Contour, 0, drops.size()}};
  return layer;
}

TEST(DropFilling, FillsBetweenAlignedRowsFromACertainDistance) {
  for (const double overlap : {0.0, 0.1, 0.2}) {
    // The middle of a cell is half its diagonal from the four drops round it.
    const double least = std::sqrt(4.0 * std::pow(1.0 - overlap, 2.0) - 1.0);
    EXPECT_EQ(addedTo(twoRows(least - 1e-3, 0.0), overlap), 0U);
    const DropLayer layer = twoRows(least + 1e-3, 0.0);
    const std::vector<Point2> drops = newDrops(fillDropVoids(layer, allowing(overlap)));
    EXPECT_EQ(drops.size(), 20U);
    for (const Point2& drop : drops) EXPECT_NEAR(drop.y(), 0.5 * (least + 1e-3), 1e-9);
  }
}

TEST(DropFilling, FillsBetweenStaggeredRowsFromACertainDistance) {
  for (const double overlap : {0.0, 0.1, 0.2}) {
    // The radius of the circle through two drops of a row and the one between them of the other.
    const double radius = 1.0 - overlap;
    const double least = radius + std::sqrt(radius * radius - 0.25);
    EXPECT_EQ(addedTo(twoRows(least - 1e-3, 0.5), overlap), 0U);
    const std::vector<DropVoid> voids = fillDropVoids(twoRows(least + 1e-3, 0.5), allowing(overlap));
    EXPECT_EQ(voids.size(), 1U);
    EXPECT_EQ(newDrops(voids).size(), 20U);
  }
}

TEST(DropFilling, FillsASlitAsWideAsItsOverlapAllows) {
  // Contours as nearly continuous lines, w + 1 apart: a slit of free width w.
  const auto slit = [](double free_width) {
    DropLayer layer;
    layer.diameter_mm = 1.0;
    for (int i = 0; i <= 2000; ++i) layer.drops.emplace_back(0.005 * i, 0.0);
    for (int i = 2000; i >= 0; --i) layer.drops.emplace_back(0.005 * i, free_width + 1.0);
    layer.chains = {{DropRole::Contour, 0, layer.drops.size()}};
    return layer;
  };
  for (const double overlap : {0.1, 0.2}) {
    EXPECT_EQ(addedTo(slit(1.0 - 2.0 * overlap - 0.01), overlap), 0U);
    const double free_width = 1.0 - 2.0 * overlap + 0.01;
    const std::vector<DropVoid> voids = fillDropVoids(slit(free_width), allowing(overlap));
    ASSERT_EQ(voids.size(), 1U);
    EXPECT_NEAR(voids[0].greatest_clearance_mm, 0.5 * (free_width + 1.0), 1e-5);
    EXPECT_GT(voids[0].drops.size(), 5U);
    for (const Point2& drop : voids[0].drops) EXPECT_NEAR(drop.y(), 0.5 * (free_width + 1.0), 1e-6);
  }
}

TEST(DropFilling, PutsOneDropBetweenTheTipsOfContours) {
  // Two contours a diameter apart as nearly continuous lines, their tips at 60 degrees 2 diameters apart.
  // The place clear of both is 1 / (1 + sin 30) from the tip of the outer one's legs and of the inner tip.
  constexpr double kClearance = 2.0 / 3.0;
  constexpr double kLeg = 6.0;
  DropLayer layer;
  layer.diameter_mm = 1.0;
  for (const double tip : {0.0, 2.0}) {
    const std::size_t begin = layer.drops.size();
    const Point2 apex(tip, 0.0);
    const Point2 corners[] = {apex, apex + (kLeg - tip) * Point2(1.0, -std::sqrt(1.0 / 3.0)),
                              apex + (kLeg - tip) * Point2(1.0, std::sqrt(1.0 / 3.0))};
    for (int side = 0; side < 3; ++side)
      for (int i = 0; i < 2000; ++i)
        layer.drops.emplace_back(corners[side] + i / 2000.0 * (corners[(side + 1) % 3] - corners[side]));
    layer.chains.push_back({DropRole::Contour, begin, layer.drops.size()});
  }
  const auto betweenTips = [&](double overlap) {
    DropVoidSettings settings = allowing(overlap);
    settings.passes = VoidPasses::UntilFull;
    std::vector<Point2> drops = newDrops(fillDropVoids(layer, settings));
    drops.erase(std::remove_if(drops.begin(), drops.end(),
                               [](const Point2& drop) { return drop.x() > 2.0 || std::abs(drop.y()) > 0.1; }),
                drops.end());
    return drops;
  };
  EXPECT_TRUE(betweenTips(1.0 - kClearance - 0.01).empty());
  const std::vector<Point2> drops = betweenTips(1.0 - kClearance + 0.01);
  ASSERT_EQ(drops.size(), 1U);
  EXPECT_NEAR(drops[0].x(), 2.0 * kClearance, 0.02 + 1e-6) << "where the legs leave 0.01 less room";
  EXPECT_NEAR(drops[0].y(), 0.0, 0.01);
}

/// Room in a square of contours, each two diameters less wide than the one round it. The innermost one is
/// four drops, the next one has three gaps a side.
struct CoreRoom {
  double middle;  ///< from the middle to the four drops
  double beside;  ///< from four places between the two contours to two drops of either

  explicit CoreRoom(double side) {
    const double half = 0.5 * std::fmod(side - 1.0, 2.0);
    const double half_gap = (half + 1.0) / 3.0;
    // Equally far from (half, half) as from (half_gap, half + 1), on the axis of symmetry.
    const double place = 0.5 * (half_gap * half_gap + (half + 1.0) * (half + 1.0)) - half * half;
    middle = half * std::sqrt(2.0);
    beside = std::hypot(half, place - half);
  }
};

TEST(DropFilling, OfSquaresOfContoursAddsWhatTheirCoresHaveRoomFor) {
  const auto square = [](double side) {
    return filledLayer("drops_contour", {{rectangle(0, 0, side, side), {}}}, 1.0);
  };
  for (const double side : {10.0, 10.3, 10.6, 10.8, 12.6})
    for (const double overlap : {0.0, 0.1, 0.2}) {
      const CoreRoom room(side);
      const std::size_t added =
          (room.middle > 1.0 - overlap ? 1U : 0U) + (room.beside > 1.0 - overlap ? 4U : 0U);
      EXPECT_EQ(addedTo(square(side), overlap), added) << side << " mm, overlap " << overlap;
    }
  EXPECT_EQ(addedTo(square(10.0), 0.3), 9U * 9U) << "the pores of a lattice of 10 by 10";
}

TEST(DropFilling, OverlapsMoreAndMoreAboveThePoresOfASquareLattice) {
  const DropLayer layer = filledLayer("drops_contour", {{rectangle(0, 0, 10.6, 10.6), {}}}, 1.0);
  const auto perDrop = [&layer](double overlap) {
    DropVoidSettings settings = allowing(overlap);
    settings.passes = VoidPasses::UntilFull;
    return measureOverlap(layer.drops, newDrops(fillDropVoids(layer, settings)), 1.0).perDrop();
  };
  // The one in the middle overlaps with none, the four beside it with four drops each.
  const double shared = overlapAt(CoreRoom(10.6).beside, OverlapDefinition::Area);
  EXPECT_NEAR(perDrop(0.0), 0.0, 1e-9);
  EXPECT_NEAR(perDrop(0.1), 0.0, 1e-9);
  EXPECT_NEAR(perDrop(0.2), 16.0 * shared / 105.0, 5e-5);
  // Pores of 1 by 1 at corners, of 1 by 6/5 diameters at most: their middles are 0.71 to 0.78 from four
  // drops, each of which shares 0.12 to 0.182. Some 80 of them share that with 100 drops.
  EXPECT_GT(perDrop(0.3), 80.0 * 4.0 * 0.12 / 180.0);
  EXPECT_LT(perDrop(0.3), 81.0 * 4.0 * 0.182 / 181.0);
  EXPECT_GE(perDrop(0.4), perDrop(0.3));
}

TEST(DropFilling, DoesNotDependOnSizePlaceAndDirection) {
  const double angle = 17.0 * M_PI / 180.0;
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  DropLayer layer = hexWithout({hexSite(-2, 0), hexSite(2, 0), hexSite(2, 1), hexSite(3, 0)});
  DropLayer moved = layer;
  moved.diameter_mm = 0.2;
  for (Point2& drop : moved.drops) drop = turn * (0.2 * drop) + Point2(100, 100);
  const std::vector<DropVoid> voids = fillDropVoids(layer, allowing(0.2));
  const std::vector<DropVoid> moved_voids = fillDropVoids(moved, allowing(0.2));
  EXPECT_EQ(voids.size(), 2U);
  EXPECT_EQ(moved_voids.size(), 2U);
  EXPECT_EQ(newDrops(voids).size(), 4U);
  EXPECT_EQ(newDrops(moved_voids).size(), 4U);
  EXPECT_NEAR(measureOverlap(moved.drops, newDrops(moved_voids), 0.2).perNewDrop(), 0.0, 1e-6);
  for (std::size_t i = 0; i < 2; ++i) {  // the order of voids turns with the layer
    const DropVoid& original = voids[i];
    const DropVoid& other = moved_voids[original.drops.size() == moved_voids[i].drops.size() ? i : 1 - i];
    EXPECT_EQ(other.kind, original.kind);
    EXPECT_NEAR(other.greatest_clearance_mm, 0.2 * original.greatest_clearance_mm, 1e-9);
    EXPECT_NEAR(other.uncovered_after_mm2 / other.uncovered_before_mm2,
                original.uncovered_after_mm2 / original.uncovered_before_mm2, 0.01);
  }
}

TEST(DropFilling, ByNeighboursGivesTheDropsOfTheVoronoiDiagram) {
  const std::vector<DropLayer> layers = {squareWithout({{0, 0}}),
                                         hexWithout({}),
                                         hexWithout({hexSite(0, 0)}),
                                         hexWithout({hexSite(0, 0), hexSite(1, 0)}),
                                         hexWithout({hexSite(-2, 0), hexSite(2, 0)}),
                                         hexWithout({hexSite(0, 0), hexSite(1, 0), hexSite(0, 1)})};
  for (std::size_t i = 0; i < layers.size(); ++i)
    for (const double overlap : {0.0, 0.1, 0.2, 0.25}) {
      SCOPED_TRACE(testing::Message() << "layer " << i << ", overlap " << overlap);
      expectDropsAt(newDrops(fillDropVoids(layers[i], allowing(overlap, VoidDetector::Neighbours))),
                    newDrops(fillDropVoids(layers[i], allowing(overlap))));
    }
}

TEST(DropFilling, ByNeighboursMissesTheMiddleOfARowInOnePass) {
  const DropLayer layer = hexWithout({hexSite(-1, 0), hexSite(0, 0), hexSite(1, 0)});
  DropVoidSettings settings = allowing(0.2, VoidDetector::Neighbours);
  EXPECT_EQ(newDrops(fillDropVoids(layer, settings)).size(), 2U);
  EXPECT_EQ(newDrops(fillDropVoids(layer, allowing(0.2))).size(), 3U);
  settings.overlap = 0.0;
  settings.passes = VoidPasses::UntilFull;
  const std::vector<DropVoid> voids = fillDropVoids(layer, settings);
  EXPECT_EQ(newDrops(voids).size(), 3U);
  EXPECT_EQ(voids.size(), 2U) << "the second pass works on a void of the first";
}

TEST(DropFilling, LaysNothingWithoutAContour) {
  DropLayer layer;
  layer.diameter_mm = 1.0;
  EXPECT_TRUE(fillDropVoids(layer, {}).empty());
  layer.drops = {{0, 0}, {5, 0}, {0, 5}, {5, 5}, {5, 5}};
  layer.chains = {{DropRole::Infill, 0, 5}};
  EXPECT_TRUE(fillDropVoids(layer, {}).empty());
  layer.chains = {{DropRole::Contour, 0, 2}, {DropRole::Infill, 2, 5}};
  EXPECT_TRUE(fillDropVoids(layer, {}).empty()) << "two drops enclose nothing";
}

TEST(DropFilling, LaysNothingIntoContoursThatEncloseNothing) {
  const std::vector<std::vector<Point2>> contours = {
      {{1, 1}},                              // one drop
      {{1, 1}, {4, 5}},                      // two
      {{0, 0}, {3, 0}, {6, 0}, {9, 0}},      // in a line
      {{0, 0}, {3, 3}, {6, 6}, {3, 3}},      // there and back
      std::vector<Point2>(6, Point2(3, 3)),  // one place over and over
      {{0, 0}, {0, 0}, {5, 0}, {5, 0}}};     // two places
  for (const std::vector<Point2>& drops : contours)
    for (const VoidDetector detector : {VoidDetector::Voronoi, VoidDetector::Neighbours})
      for (const VoidPasses passes : {VoidPasses::Single, VoidPasses::UntilFull}) {
        DropLayer layer;
        layer.diameter_mm = 1.0;
        layer.drops = drops;
        layer.chains = {{DropRole::Contour, 0, drops.size()}};
        DropVoidSettings settings = allowing(0.2, detector);
        settings.passes = passes;
        EXPECT_TRUE(newDrops(fillDropVoids(layer, settings)).empty()) << drops.size() << " drops";
      }
}

TEST(DropFilling, FillsALatticeWhoseDropsAreDoubledAsIfTheyWereNot) {
  DropLayer layer = squareWithout({{1, 1}});
  layer.drops.insert(layer.drops.end(), layer.drops.begin(), layer.drops.end());
  layer.chains.push_back({DropRole::Infill, layer.drops.size() / 2, layer.drops.size()});
  const std::vector<DropVoid> voids = fillDropVoids(layer, allowing(0.2));
  ASSERT_EQ(voids.size(), 1U);
  expectDropsAt(voids[0].drops, {{1, 1}});
}

TEST(DropFilling, RefusesDropsWithoutSize) { EXPECT_THROW(fillDropVoids(DropLayer{}, {}), InvalidInput); }

}  // namespace
}  // namespace lamina
