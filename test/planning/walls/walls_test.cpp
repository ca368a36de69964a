// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/walls/walls.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;
using test::reversed;

constexpr double kWallsPitch = 0.4;

Walls wallsIn(const Regions& material, const PlanSettings& settings, double pitch = kWallsPitch) {
  return makeWalls(material, settings, pitch, WallContact::Overlapping);
}

PlanSettings wallsOf(int count) {
  PlanSettings settings;
  settings.walls.count = count;
  return settings;
}

Regions square(double side) { return {{rectangle(0, 0, side, side), {}}}; }

TEST(Walls, OfASquareAreSquaresABeadApart) {
  const Walls walls = wallsIn(square(20), wallsOf(3));
  ASSERT_EQ(walls.walls.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(perimeter(walls.walls[k].centre_lines[0].outer),
                4 * (20 - 0.8 * (static_cast<double>(k) + 0.5)), 1e-3);
}

TEST(Walls, LieAPitchApart) {
  const Walls walls = wallsIn(square(20), wallsOf(2), 0.3);
  EXPECT_NEAR(perimeter(walls.walls[0].centre_lines[0].outer), 4 * 19.6, 1e-3);
  EXPECT_NEAR(perimeter(walls.walls[1].centre_lines[0].outer), 4 * (19.6 - 2 * 0.3), 1e-3);
}

TEST(Walls, LeaveWhatTheyDoNotFillToTheInfill) {
  const Walls walls = makeWalls(square(20), wallsOf(2), kWallsPitch, WallContact::Beside);
  EXPECT_NEAR(area(walls.infill), std::pow(20 - 2 * 0.8, 2), 1e-2);
}

TEST(Walls, AreRunIntoByInfillThatOverlapsThem) {
  PlanSettings settings = wallsOf(2);
  settings.infill.wall_overlap = 0.25;
  EXPECT_NEAR(area(wallsIn(square(20), settings).infill), std::pow(20 - 2 * (0.8 - 0.1), 2), 1e-2);
}

TEST(Walls, WhereThereAreNoneTheBeadsOfTheInfillReachTheOutline) {
  EXPECT_NEAR(area(wallsIn(square(20), wallsOf(0)).infill), 20 * 20, 1e-2);
  // Beads 0.4 wide at a pitch of 0.3 reach 0.05 beyond what they fill.
  EXPECT_NEAR(area(wallsIn(square(20), wallsOf(0), 0.3).infill), 19.9 * 19.9, 1e-2);
}

TEST(Walls, EndWhereTheyDoNotFit) {
  const Walls walls = wallsIn(square(0.9), wallsOf(5));
  ASSERT_EQ(walls.walls.size(), 2U);
  EXPECT_EQ(walls.walls[0].centre_lines.size(), 1U);
  EXPECT_TRUE(walls.walls[1].centre_lines.empty());
  EXPECT_TRUE(walls.walls[1].thin.empty());  // 0.1 mm are left
  EXPECT_TRUE(walls.infill.empty());
}

/// A neck of that width between two squares.
Regions dumbbell(double neck) {
  return unite(
      {rectangle(0, 0, 10, 10), rectangle(20, 0, 30, 10), rectangle(9, 5 - 0.5 * neck, 21, 5 + 0.5 * neck)});
}

double lengthOfThin(const Wall& wall) {
  double sum = 0.0;
  for (const FillPath& run : wall.thin) sum += length(run.points);
  return sum;
}

TEST(Walls, AreOneBeadWhereThereIsNoRoomForLoops) {
  const Walls walls = wallsIn(dumbbell(0.5), wallsOf(2));
  ASSERT_EQ(walls.walls.size(), 2U);
  EXPECT_EQ(walls.walls[0].centre_lines.size(), 2U);  // the squares
  ASSERT_EQ(walls.walls[0].thin.size(), 1U);
  const FillPath& bead = walls.walls[0].thin[0];
  EXPECT_EQ(bead.role, PathRole::OuterWall);
  EXPECT_NEAR(lengthOfThin(walls.walls[0]), 10.0, 0.6);
  for (const double width : bead.width_mm) EXPECT_NEAR(width, 0.5, 0.05);
  EXPECT_EQ(walls.unprinted_mm2, 0.0);
}

/// A square of 20 mm with a fin of a bead's width on it.
Regions withFin(double length_mm) {
  return {{{{0, 0},
            {20, 0},
            {20, 20},
            {10.4, 20},
            {10.4, 20 + length_mm},
            {10, 20 + length_mm},
            {10, 20},
            {0, 20}},
           {}}};
}

TEST(Walls, HaveNoBeadInAFinThatIsShorterThanWide) {
  EXPECT_TRUE(wallsIn(withFin(0.6), wallsOf(1)).walls[0].thin.empty()) << "0.2 mm between two round ends";
  const std::vector<FillPath> thin = wallsIn(withFin(2.0), wallsOf(1)).walls[0].thin;
  ASSERT_EQ(thin.size(), 1U);
  EXPECT_GT(length(thin[0].points), 1.5);
}

TEST(Walls, KeepAShortBeadThatIsAllThereIs) {
  const Walls walls = wallsIn({{rectangle(0, 0, 0.4, 0.6), {}}}, wallsOf(1));
  ASSERT_EQ(walls.walls[0].thin.size(), 1U);
  EXPECT_LT(length(walls.walls[0].thin[0].points), 0.4);
}

TEST(Walls, FillWhatIsLeftBetweenThemByABead) {
  // Two loops of 0.4 mm on each side leave 0.3 mm.
  const Walls walls = wallsIn({{rectangle(0, 0, 20, 1.9), {}}}, wallsOf(3));
  ASSERT_EQ(walls.walls.size(), 3U);
  EXPECT_TRUE(walls.walls[2].centre_lines.empty());
  ASSERT_EQ(walls.walls[2].thin.size(), 1U);
  EXPECT_EQ(walls.walls[2].thin[0].role, PathRole::GapFill);
  for (const double width : walls.walls[2].thin[0].width_mm) EXPECT_NEAR(width, 0.3, 0.01);
}

TEST(Walls, FillADiscOfTheRadiusThatTheLastOneVanishesAt) {
  // The second centre line would shrink to the middle of the disc.
  const Walls walls = wallsIn({{test::circle({0, 0}, 0.6, 90), {}}}, wallsOf(2));
  ASSERT_EQ(walls.walls.size(), 2U);
  EXPECT_EQ(walls.walls[0].centre_lines.size(), 1U);
  EXPECT_TRUE(walls.walls[1].centre_lines.empty());
  EXPECT_EQ(walls.walls[1].thin.size(), 1U);
}

TEST(Walls, LeaveBeadsAlongNarrowPlacesInsteadOfASolidInfill) {
  const PlanSettings settings = wallsOf(1);
  const Regions strip = {{rectangle(0, 0, 20, 1.4), {}}};  // 0.6 mm between the walls
  const Walls solid = makeWalls(strip, settings, kWallsPitch, WallContact::Fitted);
  ASSERT_EQ(solid.narrow_infill.size(), 1U);
  EXPECT_EQ(solid.narrow_infill[0].role, PathRole::GapFill);
  for (const double width : solid.narrow_infill[0].width_mm) EXPECT_NEAR(width, 0.6, 0.01);
  EXPECT_LT(area(solid.infill), 0.05);
  const Walls sparse = makeWalls(strip, settings, kWallsPitch, WallContact::Overlapping);
  EXPECT_TRUE(sparse.narrow_infill.empty());
  EXPECT_GT(area(sparse.infill), 19.2 * 0.6);  // it overlaps the wall
}

/// What a ring of a square of 40 mm leaves, so wide, for two walls.
FittedArea gapOfRing(double width_mm, double overlap_mm) {
  const Regions ring = {
      {rectangle(0, 0, 40, 40), {reversed(rectangle(width_mm, width_mm, 40 - width_mm, 40 - width_mm))}}};
  return withoutNarrowGaps(ring, ring, overlap_mm, wallsOf(2), kWallsPitch);
}

TEST(Walls, AreJoinedByBeadsWhereASparseInfillHasNoRoom) {
  for (const double overlap : {0.0, 0.06}) {
    // The infill reaches into the walls on both sides; 0.3 mm are between them.
    const FittedArea gap = gapOfRing(0.3 + 2.0 * overlap, overlap);
    EXPECT_LT(area(gap.wide), 1e-3);
    ASSERT_EQ(gap.narrow.size(), 1U);
    EXPECT_EQ(gap.narrow[0].role, PathRole::GapFill);
    EXPECT_TRUE(gap.narrow[0].is_closed);
    const auto widths = std::minmax_element(gap.narrow[0].width_mm.begin(), gap.narrow[0].width_mm.end());
    EXPECT_NEAR(*widths.first, 0.3, 0.01);
    EXPECT_LT(*widths.second, 0.3 * M_SQRT2 + 0.01) << "at the corners";
    EXPECT_NEAR(perimeter(gap.narrow[0].points), 4.0 * (40.0 - 0.3 - 2.0 * overlap), 1.0);
  }
}

TEST(Walls, LeaveWhatIsWiderThanABeadToASparseInfill) {
  const FittedArea wide = gapOfRing(0.45, 0.0);
  EXPECT_TRUE(wide.narrow.empty());
  EXPECT_NEAR(area(wide.wide), 40 * 40 - 39.1 * 39.1, 1e-3);
  // No bead where there are no walls to be joined, or where others fill the gap.
  const Regions gap = {{rectangle(0, 0, 40, 0.3), {}}};
  EXPECT_TRUE(withoutNarrowGaps(gap, gap, 0.0, wallsOf(0), kWallsPitch).narrow.empty());
  EXPECT_TRUE(withoutNarrowGaps(gap, {}, 0.0, wallsOf(2), kWallsPitch).narrow.empty());
}

TEST(Walls, CountWhatIsTooThinToBePrinted) {
  const Walls walls = wallsIn(dumbbell(0.1), wallsOf(1));
  EXPECT_TRUE(walls.walls[0].thin.empty());
  EXPECT_NEAR(walls.unprinted_mm2, 10 * 0.1, 0.05);
  EXPECT_NEAR(wallsIn(dumbbell(0.1), wallsOf(0)).unprinted_mm2, 10 * 0.1, 0.05);
}

TEST(Walls, RunAroundHolesToo) {
  const Walls walls = wallsIn({{rectangle(0, 0, 20, 20), {reversed(rectangle(5, 5, 15, 15))}}}, wallsOf(1));
  ASSERT_EQ(walls.walls[0].centre_lines.size(), 1U);
  EXPECT_NEAR(perimeter(walls.walls[0].centre_lines[0].holes[0]), 4 * 10.4, 1e-3);
}

TEST(Walls, LieAsFarInsideTheOutlineAsTheirNumberSays) {
  EXPECT_TRUE(rc::check("random regions", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions material = unite(
        {test::star(random, {0, 0}, 6.0, 12.0, 30), reversed(test::star(random, {0, 0}, 1.0, 3.0, 10))});
    const std::vector<Polygon> borders = outlines(material);
    const Walls walls = wallsIn(material, wallsOf(3));
    for (std::size_t k = 0; k < walls.walls.size(); ++k)
      for (const Polygon& loop : outlines(walls.walls[k].centre_lines))
        for (const Point2& point : loop) {
          RC_ASSERT(contains(borders, point));
          RC_ASSERT(test::distanceToOutline(borders, point) > 0.4 * (static_cast<double>(k) + 0.5) - 1e-4);
        }
  }));
}

}  // namespace
}  // namespace lamina
