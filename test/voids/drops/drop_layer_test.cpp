// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/drops/drop_layer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/drop_lattices.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::filledLayer;
using test::rectangle;
using test::reversed;

std::size_t countBorders(const std::vector<DropContour>& contours) { return borders(contours).size(); }

TEST(DropContours, OfAFillOfContoursHaveOneBorderPerOutline) {
  const Regions plate = {{rectangle(0, 0, 30, 20), {reversed(circle({10, 10}, 4, 60))}},
                         {rectangle(40, 0, 50, 10), {}}};
  const std::vector<DropContour> contours = contoursOf(filledLayer("drops_contour", plate, 1.0));
  EXPECT_GT(contours.size(), 10U);
  const std::vector<Polygon> found = borders(contours);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_TRUE(contains(found, {2, 2}));
  EXPECT_FALSE(contains(found, {10, 10})) << "in the hole";
  EXPECT_TRUE(contains(found, {45, 5}));
  EXPECT_FALSE(contains(found, {35, 5}));
}

TEST(DropContours, KnowAnIslandInAHole) {
  const Regions regions = {{circle({0, 0}, 20, 120), {reversed(circle({0, 0}, 12, 90))}},
                           {circle({0, 0}, 7, 60), {}}};
  EXPECT_EQ(countBorders(contoursOf(filledLayer("drops_contour", regions, 1.0))), 3U);
}

/// Drops 1 mm apart on part of a circle about the origin, clockwise.
std::vector<Point2> arcOfDrops(double radius, double part) {
  std::vector<Point2> drops;
  const int count = static_cast<int>(2.0 * M_PI * radius);
  for (int i = 0; i < part * count; ++i)
    drops.emplace_back(radius * std::cos(2.0 * M_PI * i / count), -radius * std::sin(2.0 * M_PI * i / count));
  return drops;
}

/// The same drops the other way.
std::vector<Point2> backwards(std::vector<Point2> drops) {
  std::reverse(drops.begin(), drops.end());
  return drops;
}

DropLayer layerOfContours(const std::vector<std::vector<Point2>>& contours) {
  DropLayer layer;
  layer.diameter_mm = 1.0;
  for (const std::vector<Point2>& drops : contours) {
    const std::size_t begin = layer.drops.size();
    layer.drops.insert(layer.drops.end(), drops.begin(), drops.end());
    layer.chains.push_back({DropRole::Contour, begin, layer.drops.size()});
  }
  return layer;
}

TEST(DropContours, ATornOneAroundAHoleIsNoBorder) {
  // Half of the second contour around the hole lacks its drops: its outline runs through the hole.
  const std::vector<DropContour> contours = contoursOf(
      layerOfContours({backwards(arcOfDrops(8.0, 1.0)), arcOfDrops(3.0, 1.0), arcOfDrops(4.0, 0.5)}));
  ASSERT_EQ(contours.size(), 3U);
  EXPECT_TRUE(contours[0].is_border);
  EXPECT_TRUE(contours[1].is_border);
  EXPECT_FALSE(contours[2].is_border);
  EXPECT_FALSE(contains(borders(contours), Point2(0, 0)));
  EXPECT_TRUE(contains(borders(contours), Point2(5, 0)));
}

TEST(DropContours, ATornOneAcrossAHoleIsNotBetweenTheContoursOfTheHole) {
  // The third contour from outside lacks half its drops: its outline runs through the hole, encloses the
  // first drop of the contour of the hole, and less than the second contour around the hole does.
  std::vector<Point2> hole = arcOfDrops(3.0, 1.0);
  std::rotate(hole.begin(), hole.begin() + 4, hole.end());
  const std::vector<DropContour> contours =
      contoursOf(layerOfContours({backwards(arcOfDrops(8.0, 1.0)), hole, backwards(arcOfDrops(7.0, 1.0)),
                                  arcOfDrops(4.0, 1.0), backwards(arcOfDrops(5.0, 0.5))}));
  ASSERT_EQ(contours.size(), 5U);
  EXPECT_TRUE(contours[0].is_border);
  EXPECT_TRUE(contours[1].is_border);
  EXPECT_FALSE(contours[2].is_border);
  EXPECT_FALSE(contours[3].is_border);
  EXPECT_FALSE(contours[4].is_border);
  EXPECT_FALSE(contains(borders(contours), Point2(0, 0)));
  EXPECT_TRUE(contains(borders(contours), Point2(3.5, 0)));
}

TEST(GuessedChains, FindTheContourOfAnInfill) {
  for (const char* strategy : {"drops_raster", "drops_dense"}) {
    DropLayer layer = filledLayer(strategy, {{rectangle(0, 0, 20, 15), {}}}, 1.0);
    layer.chains = guessChains(layer.drops, 1.0);
    const std::vector<Polygon> found = borders(contoursOf(layer));
    ASSERT_EQ(found.size(), 1U) << strategy;
    EXPECT_NEAR(signedArea(found[0]), 19.0 * 14.0, 1e-6);
  }
}

TEST(GuessedChains, FindAHole) {
  DropLayer layer =
      filledLayer("drops_raster", {{rectangle(0, 0, 20, 20), {reversed(rectangle(7, 7, 13, 13))}}}, 1.0);
  layer.chains = guessChains(layer.drops, 1.0);
  const std::vector<Polygon> found = borders(contoursOf(layer));
  EXPECT_FALSE(contains(found, {10, 10}));
  EXPECT_TRUE(contains(found, {4, 4}));
}

TEST(GuessedChains, HoldEachDropOnce) {
  const std::vector<Point2> drops = filledLayer("drops_contour", {{circle({0, 0}, 9, 80), {}}}, 1.0).drops;
  std::size_t next = 0;
  for (const DropChain& chain : guessChains(drops, 1.0)) {
    EXPECT_EQ(chain.begin, next);
    next = chain.end;
  }
  EXPECT_EQ(next, drops.size());
  EXPECT_TRUE(guessChains({}, 1.0).empty());
}

}  // namespace
}  // namespace lamina
