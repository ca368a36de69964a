// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/bead_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr Bead kFilament{0.4, 0.2};
constexpr double kLength = 20.0;  // mm

double areaOfFilament() { return 0.2 * 0.2 + M_PI * 0.1 * 0.1; }

/// Depth of a stadium as high as planned that holds a share of the planned section; a layer deep beside it.
double depthOf(double share, double across_mm) {
  const double width = kFilament.width_mm - (1.0 - share) * areaOfFilament() / kFilament.height_mm;
  const double from_flat = std::abs(across_mm) - 0.5 * (width - kFilament.height_mm);
  if (from_flat <= 0.0) return 0.0;
  return from_flat < 0.1 ? 0.1 - std::sqrt(0.01 - from_flat * from_flat) : kFilament.height_mm;
}

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

LayerCells filamentCells(std::size_t layer, const std::vector<double>& beads_y) {
  const double z = kFilament.height_mm * static_cast<double>(layer + 1);
  ToolpathLayer beads{z, kFilament.height_mm, {}};
  for (const double y : beads_y) {
    Path path;
    path.role = PathRole::OuterWall;
    path.bead = kFilament;
    path.feed_mm_s = 30.0;
    path.points = {{0, y, z}, {kLength, y, z}};
    beads.paths.push_back(path);
  }
  return layerCells(beads, layer, 0.5);
}

/// A profile across beads along x, seen from above; a point every 0.02 mm.
SensorProfile profileOver(const LayerCells& cells, double x, double share, double phase_mm) {
  const double top = cells.middle[0].z();
  SensorProfile profile;
  profile.toolpath_from_sensor.linear().col(0) = Eigen::Vector3d::UnitY();
  profile.toolpath_from_sensor.linear().col(1) = Eigen::Vector3d::UnitX();
  profile.toolpath_from_sensor.linear().col(2) = -Eigen::Vector3d::UnitZ();
  profile.toolpath_from_sensor.translation() = Point3(x, 0.0, top + 60.0);
  for (int i = -40; i <= 80; ++i) {
    const double y = 0.02 * i + phase_mm;
    double depth = 1.0;  // beside the wall
    for (const CellRun& run : cells.runs)
      depth = std::min(depth, depthOf(share, y - cells.middle[run.first].y()));
    profile.points.emplace_back(y, 0.0, 60.0 + depth);
  }
  return profile;
}

TEST(ReadSections, ReadsEachBeadOfTheNewestLayer) {
  CellAtlas atlas;
  atlas.add(std::make_shared<const LayerCells>(filamentCells(0, {0.0, 0.4})));
  const auto cells = std::make_shared<const LayerCells>(filamentCells(1, {0.0, 0.4}));
  atlas.add(cells);
  const auto sections = readSections(profileOver(*cells, 5.1, 0.85, 0.003), atlas, {});
  ASSERT_EQ(sections.size(), 2U);
  for (std::size_t bead = 0; bead < 2; ++bead) {
    EXPECT_EQ(sections[bead].layer, 1U);
    EXPECT_EQ(sections[bead].cell, 40 * bead + 10);
    EXPECT_NEAR(sections[bead].deficit, 0.15, 0.06) << "a point at each edge more or less";
  }
}

/// Share that is missing in the last of fifteen layers of a wall that is fed 15 % too little.
double openShare(LoopState state) {
  LoopSettings settings;
  settings.process = LoopProcess::Pressed;
  HeightLoop loop(settings);
  Random random(1);
  double fed = 0.0;
  for (std::size_t k = 0; k < 15; ++k) {
    const auto cells = std::make_shared<const LayerCells>(filamentCells(k, {0.0}));
    loop.beginLayer(*cells);
    const LayerCorrection correction = loop.correction(state);
    loop.lay(correction);
    fed = 0.85 * (1.0 + meanOverCells(*cells, correction.amount));
    CellAtlas atlas;
    atlas.add(cells);
    for (int i = 1; i < 80; ++i) {
      seeSections(loop, profileOver(*cells, kLength * i / 80.0, fed, random.uniform(0.0, 0.02)), atlas, {});
      loop.endCloud();
    }
    loop.endLayer();
  }
  return 1.0 - fed;
}

TEST(ReadSections, FillAWallThatIsFedTooLittle) {
  EXPECT_NEAR(openShare(LoopState::Identifying), 0.15, 1e-12);
  EXPECT_LT(openShare(LoopState::Active), 0.4 * 0.15) << "six tenths less at least";
}

TEST(ReadSections, SayNothingToAFreeProcess) {
  HeightLoop loop{LoopSettings()};
  const auto cells = std::make_shared<const LayerCells>(filamentCells(0, {0.0}));
  loop.beginLayer(*cells);
  CellAtlas atlas;
  atlas.add(cells);
  seeSections(loop, profileOver(*cells, 5.1, 0.85, 0.0), atlas, {});
  for (const double deficit : loop.stored().deficit) EXPECT_EQ(deficit, 0.0);
}

}  // namespace
}  // namespace lamina
