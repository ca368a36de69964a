// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "lamina/planning/planner.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

constexpr double kHeight = 0.2;
constexpr double kSide = 40.0;
constexpr int kLayers = 10;

/// What is deposited for a box of kSide x kSide, per volume of the box.
double depositedPart(const PlanSettings& settings) {
  std::vector<Layer> layers;
  for (int i = 0; i < kLayers; ++i)
    layers.push_back({{kHeight * i, kHeight * (i + 1)}, {{test::rectangle(0, 0, kSide, kSide)}, {}}});
  NoProgress progress;
  return totals(planToolpath("box", layers, settings, progress)).deposited_mm3 /
         (kSide * kSide * kHeight * kLayers);
}

PlanSettings solid(double overlap) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.infill.density = 1.0;
  settings.infill.wall_overlap = overlap;
  settings.bead.overlap = overlap;
  return settings;
}

/// Part of a bead's width by which neighbours must overlap so that their stadiums hold as much as a
/// rectangle.
double fullOverlap(const BeadSettings& bead) { return (1.0 - M_PI / 4.0) * kHeight / bead.width_mm; }

TEST(DepositedVolume, OfBeadsSideBySideLacksTheCornersOfTheStadiums) {
  const PlanSettings settings = solid(0.0);
  EXPECT_NEAR(depositedPart(settings), 1.0 - fullOverlap(settings.bead), 0.02);
}

TEST(DepositedVolume, OfBeadsThatOverlapByTheCornersIsThatOfThePart) {
  EXPECT_NEAR(depositedPart(solid(fullOverlap(BeadSettings{}))), 1.0, 0.02);
}

TEST(DepositedVolume, OfInfillFollowsTheDensityPlusTheLinksOverHalfTheOutline) {
  PlanSettings settings = solid(0.0);
  settings.walls.count = 0;
  const double side = kSide - settings.bead.width_mm;
  for (const double density : {0.5, 0.25, 0.1}) {
    settings.infill.density = density;
    const double expected_mm = side * side * density / settings.bead.width_mm + 2.0 * side;
    const double expected =
        expected_mm * crossSection({settings.bead.width_mm, kHeight}) / (kSide * kSide * kHeight);
    EXPECT_NEAR(depositedPart(settings), expected, 0.02 * expected) << density;
  }
}

}  // namespace
}  // namespace lamina
