// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/grid_sections.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;
using test::reversed;

TEST(GridSections, KeepTheNodesWhoseEightNeighboursAreInside) {
  // Columns 0.2 to 38.2 and rows 0.2 to 18.2 are inside, so 2.2 to 36.2 and 2.2 to 16.2 are interior.
  const std::vector<GridSection> sections = gridSections({rectangle(0, 0, 40, 20)}, 2.0, {0.2, 0.2});
  ASSERT_EQ(sections.size(), 1U);
  const std::vector<Polyline>& passes = sections[0].passes;
  ASSERT_EQ(passes.size(), 8U);
  EXPECT_NEAR(passes.front()[0].y(), 2.2, 1e-9);
  EXPECT_NEAR(passes.back()[0].y(), 16.2, 1e-9);
  for (const Polyline& pass : passes) {
    EXPECT_NEAR(pass.front().x(), 2.2, 1e-9);
    EXPECT_NEAR(pass.back().x(), 36.2, 1e-9);
  }
}

TEST(GridSections, KeepTheirDistanceFromAnySlantedBorder) {
  // With eight neighbours the clearance is one distance at least, and the square root of two at 45 degrees.
  const Polygon diamond = {{0, -20}, {20, 0}, {0, 20}, {-20, 0}};
  const std::vector<GridSection> sections = gridSections({diamond}, 1.0, {0.3, 0.1});
  ASSERT_FALSE(sections.empty());
  for (const GridSection& section : sections)
    for (const Polyline& pass : section.passes)
      for (const Point2& end : pass)
        EXPECT_GE(test::distanceToOutline({diamond}, end), std::sqrt(2.0) - 1e-9);
}

TEST(GridSections, StandInTheOrderOfTheirCrossings) {
  // Rows beside the hole are crossed twice: below it one section, to its left, above it, and to its right
  // last.
  const std::vector<GridSection> sections =
      gridSections({rectangle(0, 0, 30, 30), reversed(rectangle(12, 12, 18, 18))}, 1.0, {0.5, 0.5});
  ASSERT_EQ(sections.size(), 4U);
  EXPECT_LT(sections[0].passes.back()[0].y(), 12.0);
  EXPECT_LT(sections[1].passes[0].back().x(), 12.0);
  EXPECT_GT(sections[2].passes.front()[0].y(), 18.0);
  EXPECT_GT(sections[3].passes[0].front().x(), 18.0);
  EXPECT_TRUE(sections[0].is_bordered_below);
  EXPECT_FALSE(sections[0].is_bordered_above);
  EXPECT_TRUE(sections[2].is_bordered_above);
}

TEST(GridSections, OfAPartTooNarrowForAnInteriorAreNone) {
  EXPECT_TRUE(gridSections({rectangle(0, 0, 40, 3)}, 2.0, {0, 0}).empty());
  EXPECT_TRUE(gridSections({}, 2.0, {0, 0}).empty());
}

}  // namespace
}  // namespace lamina
