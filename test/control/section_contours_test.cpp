// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/section_contours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "filament_contour.hpp"
#include "lamina/base/random.hpp"
#include "lamina/control/height_loop.hpp"

namespace lamina {
namespace {

using test::depthOf;
using test::kFilament;

constexpr double kLength = 20.0;  // mm

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

SectionReading readingOf(const std::vector<SectionReading>& sections, std::size_t cell) {
  for (const SectionReading& section : sections)
    if (section.cell == cell) return section;
  return {cell, std::nan("")};
}

TEST(SectionContours, AreOfEachBeadOfTheNewestLayer) {
  CellAtlas atlas;
  atlas.add(std::make_shared<const LayerCells>(filamentCells(0, {0.0, 0.4})));
  const auto cells = std::make_shared<const LayerCells>(filamentCells(1, {0.0, 0.4}));
  atlas.add(cells);
  SectionContours contours;
  contours.see(profileOver(*cells, 5.1, 0.85, 0.003), atlas, {});
  const auto sections = contours.take();
  ASSERT_EQ(sections.size(), 2U);
  for (std::size_t bead = 0; bead < 2; ++bead) {
    EXPECT_EQ(sections[bead].cell, 40 * bead + 10);
    EXPECT_NEAR(sections[bead].deficit, 0.15, 0.06) << "a point at each edge more or less";
  }
  EXPECT_TRUE(contours.take().empty()) << "nothing was added since";
}

/// A profile along a bead, at a distance beside its middle: what the line of light of a sensor shows that
/// passes over it sideways.
SensorProfile profileAlong(const LayerCells& cells, double y, double share, double beyond_mm) {
  const double top = cells.middle[0].z();
  SensorProfile profile;
  profile.toolpath_from_sensor.linear().col(1) = -Eigen::Vector3d::UnitY();
  profile.toolpath_from_sensor.linear().col(2) = -Eigen::Vector3d::UnitZ();
  profile.toolpath_from_sensor.translation() = Point3(0.5 * kLength, y, top + 60.0);
  const double depth = depthOf(share, y);
  for (int i = -90; i <= 90; ++i) {
    const bool is_beside = depth >= kFilament.height_mm;
    const double range = 60.0 + (is_beside ? beyond_mm : depth);
    profile.points.emplace_back(0.1 * i / 60.0 * range, 0.0, range);
  }
  return profile;
}

/// One by one no such profile crosses the bead: together they do, wherever the light ends up beside it.
TEST(SectionContours, AreGatheredOfABeadAlongTheLineOfLight) {
  for (const double share : {1.0, 0.85, 0.7})
    for (const double beyond_mm : {0.2, 6.0}) {
      CellAtlas atlas;
      const auto cells = std::make_shared<const LayerCells>(filamentCells(0, {0.0}));
      atlas.add(cells);
      SectionContours contours;
      for (int i = -60; i <= 60; ++i) {
        contours.see(profileAlong(*cells, 0.005 * i, share, beyond_mm), atlas, {});
        if (i < 0) {
          EXPECT_TRUE(contours.take().empty()) << "one side alone";
        }
      }
      const std::vector<SectionReading> sections = contours.take();
      for (std::size_t cell = 3; cell < 37; ++cell)
        EXPECT_NEAR(readingOf(sections, cell).deficit, 1.0 - share, 0.02)
            << share << ", cell " << cell << ", " << beyond_mm << " mm beside it";
    }
}

TEST(SectionContours, AreNotAskedForByAFreeProcess) {
  EXPECT_FALSE(HeightLoop{LoopSettings()}.readsSections());
}

/// What the layer below had shown is not the next one's.
TEST(SectionContours, BeginAnewWithEachLayer) {
  CellAtlas atlas;
  const auto cells = std::make_shared<const LayerCells>(filamentCells(0, {0.0}));
  atlas.add(cells);
  SectionContours contours;
  contours.see(profileOver(*cells, 5.1, 0.7, 0.0), atlas, {});
  contours.begin();
  EXPECT_TRUE(contours.take().empty());
  contours.see(profileOver(*cells, 5.1, 1.0, 0.0), atlas, {});
  EXPECT_NEAR(readingOf(contours.take(), 10).deficit, 0.0, 0.01);
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
    SectionContours contours;
    for (int i = 1; i < 80; ++i) {
      contours.see(profileOver(*cells, kLength * i / 80.0, fed, random.uniform(0.0, 0.02)), atlas, {});
      for (const SectionReading& section : contours.take()) loop.seeDeficit(section.cell, section.deficit);
      loop.endCloud();
    }
    loop.endLayer();
  }
  return 1.0 - fed;
}

TEST(SectionContours, FillAWallThatIsFedTooLittle) {
  EXPECT_NEAR(openShare(LoopState::Identifying), 0.15, 1e-12);
  EXPECT_LT(openShare(LoopState::Active), 0.4 * 0.15) << "six tenths less at least";
}

}  // namespace
}  // namespace lamina
