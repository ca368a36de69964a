// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/variable_width/sharp_tips.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/geometry/polygon/convex_hull.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;
using test::reversed;

/// 30 mm long, 5 mm wide: about 9.5 degrees at its tip, 85 at its other corners.
const Polygon kNeedle = {{0, -2.5}, {30, 0}, {0, 2.5}};

TEST(HasSharpCorner, OfLessThan60DegreesInside) {
  EXPECT_TRUE(hasSharpCorner({kNeedle, {}}));
  EXPECT_FALSE(hasSharpCorner({rectangle(0, 0, 5, 5), {}}));
  EXPECT_FALSE(hasSharpCorner({rectangle(-50, -50, 50, 50), {reversed(kNeedle)}})) << "material is around it";
  const Polygon dented = {{0, 0}, {9, 0}, {9, 4}, {3, 4.5}, {9, 5}, {9, 9}, {0, 9}};
  EXPECT_TRUE(hasSharpCorner({rectangle(-50, -50, 50, 50), {reversed(dented)}})) << "a spike into a hole";
}

TEST(CutSharpTips, CutsATriangleSquareAtTheReach) {
  const double reach = 0.6;
  const Regions core = offset({{kNeedle, {}}}, -reach);
  ASSERT_EQ(core.size(), 1U);
  const auto cut = cutSharpTips({kNeedle, {}}, core.front(), reach);
  ASSERT_TRUE(cut);
  ASSERT_EQ(cut->tips.size(), 1U);
  // The tip of the core is as far behind the tip as the edges, 1 in 12 aslant, need for the reach.
  const double behind = reach / std::sin(std::atan(1.0 / 12.0));
  const double length = behind - reach;
  EXPECT_NEAR(area(cut->tips), length * length / 12.0, 1e-3);
  EXPECT_NEAR(area({cut->rest}) + area(cut->tips), 75.0, 1e-9);
}

TEST(CutSharpTips, LeavesARegionWithoutSharpCornersWhole) {
  const Region square = {rectangle(0, 0, 5, 5), {}};
  const auto cut = cutSharpTips(square, {rectangle(1, 1, 4, 4), {}}, 1.0);
  ASSERT_TRUE(cut);
  EXPECT_TRUE(cut->tips.empty());
  EXPECT_EQ(cut->rest.outer, square.outer);
}

TEST(CutSharpTips, LeavesABluntEndWithinTheReachWhole) {
  const Polygon blunt = {{0, -2.5}, {23, -7.0 / 12.0}, {23, 7.0 / 12.0}, {0, 2.5}};
  const auto cut = cutSharpTips({blunt, {}}, offset({{kNeedle, {}}}, -0.6).front(), 0.6);
  ASSERT_TRUE(cut);
  EXPECT_TRUE(cut->tips.empty());
}

TEST(CutSharpTips, GivesUpWhereTheTipIsSlit) {
  const Polygon slit = {{0, -2.5}, {29, -2.5 / 30.0}, {12, 0}, {29, 2.5 / 30.0}, {0, 2.5}};
  EXPECT_FALSE(cutSharpTips({slit, {}}, offset({{kNeedle, {}}}, -0.6).front(), 0.6));
}

TEST(CutSharpTips, GivesWhatTheGrownCoreLeaves) {
  int tips = 0;
  const auto agrees = [&tips] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    Polygon points;
    for (int i = *rc::gen::inRange(3, 7); i > 0; --i)
      points.emplace_back(random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0));
    const Region region = {convexHull(points), {}};
    const double reach = random.uniform(0.05, 0.5);
    const Regions core = offset({region}, -reach);
    if (core.size() != 1) return;
    const auto cut = cutSharpTips(region, core.front(), reach);
    RC_ASSERT(cut.has_value());
    tips += static_cast<int>(cut->tips.size());
    const Regions left = difference({region}, offset(core, reach));
    RC_ASSERT(area(difference(left, cut->tips)) + area(difference(cut->tips, left)) < 1e-3);
    RC_ASSERT(std::abs(area({cut->rest}) + area(cut->tips) - area({region})) < 1e-9);
  };
  EXPECT_TRUE(rc::check("of a convex region", agrees));
  EXPECT_GT(tips, 20) << "or the property says nothing";
}

}  // namespace
}  // namespace lamina
