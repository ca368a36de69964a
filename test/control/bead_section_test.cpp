// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/bead_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "filament_contour.hpp"

namespace lamina {
namespace {

using test::areaOfFilament;
using test::depthOf;
using test::kFilament;

std::vector<ContourPoint> contourOf(double share, int points, double settled_mm) {
  std::vector<ContourPoint> contour;
  contour.reserve(static_cast<std::size_t>(points));
  for (int i = 0; i < points; ++i) {
    const double across = kFilament.width_mm * ((i + 0.5) / points - 0.5);
    contour.push_back({across, depthOf(share, across) + settled_mm});
  }
  return contour;
}

TEST(SectionDeficit, IsWhatIsMissingOfTheSection) {
  for (const double share : {1.0, 0.95, 0.85, 0.7})
    for (const double settled_mm : {0.0, 0.03, -0.03})
      EXPECT_NEAR(*sectionDeficit(contourOf(share, 400, settled_mm), kFilament), 1.0 - share, 0.005) << share;
}

/// What it compares with lies at the same places: few points tell a bead as planned as well as many do.
TEST(SectionDeficit, LacksNothingAsPlannedByFewPoints) {
  for (const int points : {6, 7, 12, 31})
    EXPECT_NEAR(*sectionDeficit(contourOf(1.0, points, 0.01), kFilament), 0.0, 1e-9) << points;
}

/// Its shoulders fill up, and what is beyond its planned width is not its own.
TEST(SectionDeficit, SeesNoMoreSurplusThanTheShouldersHold) {
  const double shoulders = (0.5 - M_PI / 8.0) * 0.04 / areaOfFilament();
  EXPECT_NEAR(*sectionDeficit(contourOf(1.5, 400, 0.0), kFilament), -shoulders, 0.005);
}

TEST(SectionDeficit, NeedsPointsAcross) {
  EXPECT_FALSE(sectionDeficit({}, kFilament));
  EXPECT_FALSE(sectionDeficit(contourOf(1.0, 4, 0.0), kFilament));
  std::vector<ContourPoint> one_side = contourOf(1.0, 40, 0.0);
  one_side.resize(25);
  EXPECT_FALSE(sectionDeficit(one_side, kFilament));
  std::vector<ContourPoint> no_crown;
  no_crown.reserve(40);
  for (const ContourPoint& point : contourOf(1.0, 40, 0.0))
    if (std::abs(point.across_mm) > 0.1) no_crown.push_back(point);
  EXPECT_FALSE(sectionDeficit(no_crown, kFilament));
}

}  // namespace
}  // namespace lamina
