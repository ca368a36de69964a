// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tools/tool_beads.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/planning/planner.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

constexpr double kToolLayer = 0.2;  // mm

/// Two nozzles, the second for infill and skins.
PlanSettings twoNozzles(double first_mm, double second_mm) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.tools.list = {{"0.name", "fine"},
                         {"1.name", "coarse"},
                         {"0.nozzle_mm", std::to_string(first_mm)},
                         {"1.nozzle_mm", std::to_string(second_mm)}};
  settings.tools.infill = 1;
  settings.tools.skin = 1;
  return settings;
}

TEST(ToolBeads, AreAsWideAsTheNozzleOfTheirToolSays) {
  const PlanSettings settings = twoNozzles(0.4, 0.8);
  EXPECT_NEAR(beadOf(PathRole::OuterWall, settings, kToolLayer).bead.width_mm, 0.4, 1e-12);
  const RoleBead infill = beadOf(PathRole::Infill, settings, kToolLayer);
  EXPECT_NEAR(infill.bead.width_mm, 0.8, 1e-12);
  EXPECT_NEAR(infill.pitch_mm, 0.8 - (1.0 - M_PI / 4.0) * kToolLayer, 1e-12);
  EXPECT_NEAR(beadOf(PathRole::TopSkin, settings, kToolLayer).bead.width_mm, 0.8, 1e-12);
  EXPECT_NEAR(beadOf(PathRole::Bridge, settings, kToolLayer).bead.width_mm, 0.4, 1e-12);
  // The width that is set is that of the walls, whatever their nozzle.
  PlanSettings wide = settings;
  wide.bead.width_mm = 0.5;
  EXPECT_NEAR(beadOf(PathRole::Infill, wide, kToolLayer).bead.width_mm, 1.0, 1e-12);
  wide.tools.walls = 1;
  wide.tools.infill = 0;
  EXPECT_NEAR(beadOf(PathRole::Infill, wide, kToolLayer).bead.width_mm, 0.25, 1e-12);
  // Of nozzles that are not known nothing follows.
  EXPECT_EQ(beadOf(PathRole::Infill, twoNozzles(0.4, 0.0), kToolLayer).bead.width_mm, 0.4);
  EXPECT_EQ(beadOf(PathRole::Infill, twoNozzles(0.0, 0.8), kToolLayer).bead.width_mm, 0.4);
}

Toolpath squareBy(const PlanSettings& settings) {
  NoProgress nobody;
  return planPart("part",
                  test::layersOf(20, [](int) { return std::vector<Polygon>{test::rectangle(0, 0, 40, 40)}; }),
                  settings, nobody)
      .toolpath;
}

double laidBy(const Toolpath& toolpath, std::uint32_t tool) {
  double sum = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.tool == tool) sum += depositedVolume(path);
  return sum;
}

TEST(ToolBeads, FillWhatTheWallsLeaveWhateverTheirWidth) {
  // Two walls of 0.4 mm leave a square whose sides are 1.471239 mm shorter.
  const double inside_mm = 40.0 - 2.0 * (0.2 + 1.5 * (0.4 - (1.0 - M_PI / 4.0) * kToolLayer));
  const double whole_mm3 = 20 * kToolLayer * inside_mm * inside_mm;
  for (const double nozzle_mm : {0.4, 0.6, 0.8}) {
    PlanSettings settings = twoNozzles(0.4, nozzle_mm);
    settings.infill.density = 1.0;
    const Toolpath solid = squareBy(settings);
    EXPECT_NEAR(laidBy(solid, 1) / whole_mm3, 1.0, 0.01) << nozzle_mm;
    settings.infill.density = 0.2;
    settings.infill.links.link = LineLink::None;
    settings.infill.wall_overlap = 0.0;
    EXPECT_NEAR(laidBy(squareBy(settings), 1) / whole_mm3, 0.2, 0.01) << nozzle_mm;
    settings.skins.top_layers = settings.skins.bottom_layers = 10;
    EXPECT_NEAR(laidBy(squareBy(settings), 1) / whole_mm3, 1.0, 0.01) << nozzle_mm;
    for (const ToolpathLayer& layer : squareBy(settings).layers)
      for (const Path& path : layer.paths)
        if (path.tool == 0 && path.role != PathRole::Travel) {
          EXPECT_NEAR(path.bead.at(0).width_mm, 0.4, 1e-9);
        }
  }
}

TEST(ToolBeads, NozzlesThatAreAlikeChangeNothing) {
  PlanSettings unknown = twoNozzles(0.0, 0.0);
  const Toolpath before = squareBy(unknown);
  const Toolpath after = squareBy(twoNozzles(0.4, 0.4));
  ASSERT_EQ(before.layers.size(), after.layers.size());
  for (std::size_t l = 0; l < before.layers.size(); ++l) {
    ASSERT_EQ(before.layers[l].paths.size(), after.layers[l].paths.size());
    for (std::size_t p = 0; p < before.layers[l].paths.size(); ++p)
      EXPECT_EQ(before.layers[l].paths[p].points, after.layers[l].paths[p].points);
  }
}

}  // namespace
}  // namespace lamina
