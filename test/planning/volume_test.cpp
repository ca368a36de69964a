// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "lamina/planning/planner.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

constexpr double kVolumeHeight = 0.2;
constexpr double kSide = 40.0;
constexpr int kLayers = 10;

/// What is deposited for a box of kSide x kSide, per volume of the box.
double depositedPart(const PlanSettings& settings) {
  std::vector<Layer> layers;
  for (int i = 0; i < kLayers; ++i)
    layers.push_back(
        {{kVolumeHeight * i, kVolumeHeight * (i + 1)}, {{test::rectangle(0, 0, kSide, kSide)}, {}}});
  NoProgress progress;
  return totals(planToolpath("box", layers, settings, progress)).deposited_mm3 /
         (kSide * kSide * kVolumeHeight * kLayers);
}

PlanSettings volumeSolid(double pitch_mm) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.infill.density = 1.0;
  settings.infill.wall_overlap = 0.0;
  settings.bead.pitch_mm = pitch_mm;
  return settings;
}

TEST(DepositedVolume, OfBeadsSideBySideLacksTheCornersOfTheStadiums) {
  const double corners = (1.0 - M_PI / 4.0) * kVolumeHeight / 0.4;
  EXPECT_NEAR(depositedPart(volumeSolid(0.4)), 1.0 - corners, 0.02);
}

TEST(DepositedVolume, IsThatOfThePartByDefault) { EXPECT_NEAR(depositedPart(volumeSolid(0.0)), 1.0, 0.02); }

TEST(DepositedVolume, OfInfillFollowsTheDensityPlusTheLinksOverHalfTheOutline) {
  PlanSettings settings = volumeSolid(0.4);
  settings.walls.count = 0;
  const double side = kSide - settings.bead.width_mm;
  for (const double density : {0.5, 0.25, 0.1}) {
    settings.infill.density = density;
    const double expected_mm = side * side * density / settings.bead.width_mm + 2.0 * side;
    const double expected =
        expected_mm * crossSection({settings.bead.width_mm, kVolumeHeight}) / (kSide * kSide * kVolumeHeight);
    EXPECT_NEAR(depositedPart(settings), expected, 0.02 * expected) << density;
  }
}

/// Two walls from either side leave gaps of 0.13 to 0.33 mm, over which no line of a sparse infill leads.
TEST(DepositedVolume, OfAThinRingIsSolidForASparseInfill) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.infill.density = 0.15;
  const double beyond = (1.0 - M_PI / 4.0) * kVolumeHeight;  // beads reach so far past what they fill
  for (const double thick : {1.6, 1.7, 1.8}) {
    const double inner = 60.0 - thick;
    const Polygon hole = test::reversed(test::rectangle(thick, thick, inner, inner));
    const std::vector<Layer> layers = {{{0.0, kVolumeHeight}, {{test::rectangle(0, 0, 60, 60), hole}, {}}}};
    NoProgress progress;
    const double deposited = totals(planToolpath("ring", layers, settings, progress)).deposited_mm3;
    const double section = 60.0 * 60.0 - (inner - thick) * (inner - thick);
    EXPECT_NEAR(deposited / (section * kVolumeHeight), 1.0 - beyond / thick, 0.01) << thick;
  }
}

}  // namespace
}  // namespace lamina
