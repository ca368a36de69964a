// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/skirt.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace lamina {
namespace {

PlanSettings skirtOf(int count) {
  PlanSettings settings;
  settings.skirt.count = count;
  settings.skirt.distance_mm = 3.0;
  return settings;
}

TEST(Skirt, GoesRoundTheHullAtItsDistanceOutermostFirst) {
  const Regions part = {{test::rectangle(0, 0, 10, 10), {}}, {test::rectangle(20, 0, 30, 10), {}}};
  const std::vector<Polygon> loops = makeSkirt(part, skirtOf(2));
  ASSERT_EQ(loops.size(), 2U);
  // A hull of 30 x 10 mm; a loop at distance d is longer by a circle of that radius.
  EXPECT_NEAR(perimeter(loops[0]), 80 + 2 * M_PI * 3.6, 0.1);
  EXPECT_NEAR(perimeter(loops[1]), 80 + 2 * M_PI * 3.2, 0.1);
}

TEST(Skirt, RoundNothingIsNone) { EXPECT_TRUE(makeSkirt({}, skirtOf(2)).empty()); }

TEST(Skirt, OfNoLoopsIsNone) {
  EXPECT_TRUE(makeSkirt({{test::rectangle(0, 0, 10, 10), {}}}, skirtOf(0)).empty());
}

}  // namespace
}  // namespace lamina
