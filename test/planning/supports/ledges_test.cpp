// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Walls that hang nearer to the part than supports come beside it.
#include "planning/supports/ledges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/verification/overhang/overhang.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

constexpr double kFullGap = 0.6;     // mm
constexpr double kLeastGap = 0.2;    // mm: as above the supports
constexpr std::size_t kUpper = 60;   // layers below it stand back
constexpr double kThreeBeads = 1.2;  // mm
constexpr WallBeads kWallsOfPrinter{0.4, 0.8};

/// A block of 20 x 20 mm whose upper layers jut out at x = 10 mm.
std::vector<Layer> blockWithLedge(double ledge_mm) {
  return test::layersOf(80, [ledge_mm](int l) {
    const double juts = static_cast<std::size_t>(l) < kUpper ? 0.0 : ledge_mm;
    return std::vector<Polygon>{rectangle(-10, -10, 10 + juts, 10)};
  });
}

PlanSettings heldUp(SupportKind kind) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.supports.use = true;
  settings.supports.kind = kind;
  settings.supports.angle_deg = 45.0;
  return settings;
}

/// The longest stretch of a wall without anything below it, or a gap below.
double longestInWalls(const Toolpath& toolpath) {
  OverhangSettings judge;
  judge.reach = 1.5;
  NoProgress nobody;
  double longest = 0.0;
  for (const UnsupportedStretch& stretch :
       findOverhangs(toolpath, Eigen::Isometry3d::Identity(), judge, nobody).stretches)
    if (kindOf(stretch.role) == RoleKind::Wall) longest = std::max(longest, stretch.length_mm);
  return longest;
}

/// From the lower layers to the nearest bead of a support, of some layers.
double nearestSupport(const Toolpath& toolpath, std::size_t begin, std::size_t end) {
  double nearest = 100.0;
  for (std::size_t l = begin; l < end; ++l)
    for (const Path& path : toolpath.layers[l].paths)
      if (path.role == PathRole::Support || path.role == PathRole::SupportInterface)
        for (const Point3& point : path.points)
          nearest = std::min(nearest, std::hypot(std::max(0.0, std::abs(point.x()) - 10.0),
                                                 std::max(0.0, std::abs(point.y()) - 10.0)));
  return nearest - 0.5 * test::kLayerPitch;
}

TEST(Ledges, AreHeldUpByColumnsAndBranchesThoughNarrowerThanTheGap) {
  for (const SupportKind kind : {SupportKind::Lattice, SupportKind::Tree})
    for (const double ledge_mm : {0.4, 0.45, 0.6, 0.8, 1.0}) {
      const Toolpath held = test::plan(blockWithLedge(ledge_mm), heldUp(kind));
      EXPECT_LE(longestInWalls(held), kThreeBeads) << ledge_mm;
      EXPECT_GE(nearestSupport(held, 0, kUpper), kLeastGap - 1e-6) << ledge_mm;
      // A millimetre below, the gap is whole.
      EXPECT_GE(nearestSupport(held, 0, kUpper - 6), kFullGap - 1e-6) << ledge_mm;
      EXPECT_LT(nearestSupport(held, 0, kUpper - 6), kFullGap + 1.0) << "stands below it";
    }
}

/// A block of 20 x 20 mm whose side at x = 10 mm leans outwards by an angle from the vertical, from 6 mm up.
std::vector<Layer> leaningBlock(double lean_deg) {
  const double step = test::kLayerHeight * std::tan(lean_deg * M_PI / 180.0);
  return test::layersOf(50, [step](int l) {
    return std::vector<Polygon>{rectangle(-10, -10, 10 + step * std::max(0, l - 30), 10)};
  });
}

TEST(HangingWalls, AreHeldUpByBranchesHoweverTheyLean) {
  for (const double lean_deg : {50.0, 58.0, 62.0, 66.0, 70.0, 75.0, 80.0})
    EXPECT_LE(longestInWalls(test::plan(leaningBlock(lean_deg), heldUp(SupportKind::Tree))), kThreeBeads)
        << lean_deg;
}

TEST(HangingWalls, AreThoseBeyondTheLayerBelow) {
  const Polygon block = rectangle(-10, -10, 10, 10);
  const auto hanging = [&](double jut_mm, double length_mm) {
    const Polygon wing = rectangle(10, -0.5 * length_mm, 10 + jut_mm, 0.5 * length_mm);
    return area(hangingWalls({Region{wing, {}}}, unite({block, wing}), kWallsOfPrinter));
  };
  // Three quarters of a bead, or hardly more, on a stretch as long as three.
  EXPECT_EQ(hanging(0.29, 20.0), 0.0);
  EXPECT_NEAR(hanging(0.31, 20.0), 0.31 * 20.0, 1e-3);
  EXPECT_EQ(hanging(0.5, 1.0), 0.0);
  EXPECT_NEAR(hanging(0.5, 1.2), 0.5 * 1.2, 1e-3);
  // Of a wing of 15 mm the walls at its three sides, two beads of 0.4 mm.
  EXPECT_NEAR(hanging(15.0, 20.0), 20.0 * 0.8 + 2 * 14.2 * 0.8, 1e-3);
  EXPECT_TRUE(hangingWalls({Region{block, {}}}, {Region{block, {}}}, {0.4, 0.0}).empty()) << "without walls";
}

TEST(Ledges, HangWithoutSupports) {
  PlanSettings settings = heldUp(SupportKind::Lattice);
  settings.supports.use = false;
  EXPECT_GT(longestInWalls(test::plan(blockWithLedge(0.45), settings)), 15.0);
}

TEST(Ledges, AreLeftWhereTheGapAboveIsNoLessThanTheOneBeside) {
  PlanSettings settings = heldUp(SupportKind::Lattice);
  settings.supports.top_gap_mm = kFullGap;
  EXPECT_EQ(ledgeGap(settings.supports), kFullGap);
  EXPECT_GE(nearestSupport(test::plan(blockWithLedge(2.0), settings), 0, kUpper), kFullGap - 1e-6);
}

TEST(Ledges, LieWhereWallsHangWithinTheGap) {
  const Regions below = {Region{rectangle(-10, -10, 10, 10), {}}};
  const auto ledges = [&](const Regions& overhang) {
    std::vector<Polygon> both = outlines(below);
    for (const Polygon& border : outlines(overhang)) both.push_back(border);
    return ledgesIn(overhang, unite(both), below, kWallsOfPrinter, heldUp(SupportKind::Lattice).supports);
  };
  // Three quarters of a bead lie beyond the part, or hardly more.
  EXPECT_TRUE(ledges({Region{rectangle(10, -10, 10.29, 10), {}}}).empty());
  EXPECT_FALSE(ledges({Region{rectangle(10, -10, 10.31, 10), {}}}).empty());
  // As long as three beads, and shorter.
  EXPECT_TRUE(ledges({Region{rectangle(10, -0.5, 10.5, 0.5), {}}}).empty());
  EXPECT_FALSE(ledges({Region{rectangle(10, -0.6, 10.5, 0.6), {}}}).empty());
  // A column of a bead stands beyond the gap of a narrow one: 0.45 mm, and 0.6 + 0.4 + 0.16 - 0.3 mm round
  // it.
  const Regions narrow = ledges({Region{rectangle(10, -5, 10.45, 5), {}}});
  ASSERT_EQ(narrow.size(), 1U);
  EXPECT_NEAR(boundingBox({narrow[0].outer}).high.x(), 10.45 + 0.86, 1e-3);
  // The walls at both sides of a wing are short; skins between them hang from wall to wall.
  EXPECT_TRUE(ledges({Region{rectangle(10, -10, 25, 10), {}}}).empty());
}

}  // namespace
}  // namespace lamina
