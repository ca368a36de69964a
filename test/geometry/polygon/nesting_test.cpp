// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/nesting.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;
using test::reversed;

TEST(Nesting, GivesEachHoleToTheRegionDirectlyRoundIt) {
  const auto regions =
      nest({reversed(rectangle(11, 11, 12, 12)), rectangle(10, 10, 20, 20), reversed(rectangle(5, 5, 25, 25)),
            rectangle(0, 0, 30, 30), rectangle(40, 0, 50, 10)});
  ASSERT_TRUE(regions);
  ASSERT_EQ(regions->size(), 3U);
  EXPECT_DOUBLE_EQ(area({(*regions)[0]}), 99.0);
  EXPECT_DOUBLE_EQ(area({(*regions)[1]}), 500.0);
  EXPECT_DOUBLE_EQ(area({(*regions)[2]}), 100.0);
}

TEST(Nesting, GivesHundredsOfHolesAndIslandsToTheirRegions) {
  std::vector<Polygon> outlines;
  outlines.reserve(801);
  for (int i = 0; i < 400; ++i) {
    const int row = i / 20;
    const double x = 4.0 * (i % 20) + 1.0, y = 4.0 * row + 1.0;
    outlines.push_back(reversed(rectangle(x, y, x + 2.0, y + 2.0)));
    outlines.push_back(rectangle(x + 0.5, y + 0.5, x + 1.5, y + 1.5));
  }
  outlines.push_back(rectangle(0, 0, 80, 80));
  const auto regions = nest(outlines);
  ASSERT_TRUE(regions);
  ASSERT_EQ(regions->size(), 401U);
  EXPECT_EQ(regions->back().holes.size(), 400U);
  EXPECT_DOUBLE_EQ(area(*regions), 80.0 * 80.0 - 400.0 * 3.0);
}

TEST(Nesting, OfNothingIsNoRegion) { EXPECT_TRUE(nest({})->empty()); }

TEST(Nesting, RefusesOutlinesThatDoNotAlternate) {
  EXPECT_FALSE(nest({rectangle(0, 0, 30, 30), rectangle(5, 5, 25, 25)}));
  EXPECT_FALSE(nest({reversed(rectangle(0, 0, 30, 30))}));
  EXPECT_FALSE(
      nest({rectangle(0, 0, 30, 30), reversed(rectangle(5, 5, 25, 25)), reversed(rectangle(6, 6, 7, 7))}));
  EXPECT_FALSE(nest({{}}));
}

}  // namespace
}  // namespace lamina
