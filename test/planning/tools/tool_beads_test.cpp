// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tools/tool_beads.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/planning/planner.hpp"
#include "planning/tools/tool_order.hpp"
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

double depositedByTool(const Toolpath& toolpath, std::uint32_t tool) {
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
    EXPECT_NEAR(depositedByTool(solid, 1) / whole_mm3, 1.0, 0.01) << nozzle_mm;
    settings.infill.density = 0.2;
    settings.infill.links.link = LineLink::None;
    settings.infill.wall_overlap = 0.0;
    EXPECT_NEAR(depositedByTool(squareBy(settings), 1) / whole_mm3, 0.2, 0.01) << nozzle_mm;
    settings.skins.top_layers = settings.skins.bottom_layers = 10;
    EXPECT_NEAR(depositedByTool(squareBy(settings), 1) / whole_mm3, 1.0, 0.01) << nozzle_mm;
    for (const ToolpathLayer& layer : squareBy(settings).layers)
      for (const Path& path : layer.paths)
        if (path.tool == 0 && path.role != PathRole::Travel) {
          EXPECT_NEAR(path.bead.at(0).width_mm, 0.4, 1e-9);
        }
  }
}

/// Two nozzles, the second for what stands beside and below the part.
PlanSettings secondForAids(double nozzle_mm) {
  PlanSettings settings = twoNozzles(0.4, nozzle_mm);
  settings.tools.infill = settings.tools.skin = 0;
  settings.tools.support = 1;
  return settings;
}

std::vector<Path> depositedAs(PathRole role, const ToolpathLayer& layer) {
  std::vector<Path> paths;
  for (const Path& path : layer.paths)
    if (path.role == role) paths.push_back(path);
  return paths;
}

TEST(ToolBeads, OfBrimsFollowTheirOwnNozzle) {
  for (const double nozzle_mm : {0.25, 0.4, 0.8}) {
    PlanSettings settings = secondForAids(nozzle_mm);
    settings.adhesion.brim.width_mm = 5.0;
    const double pitch = nozzle_mm - (1.0 - M_PI / 4.0) * kToolLayer;
    const std::vector<Path> loops = depositedAs(PathRole::Brim, squareBy(settings).layers.front());
    ASSERT_EQ(loops.size(), static_cast<std::size_t>(std::lround(5.0 / pitch))) << nozzle_mm;
    for (std::size_t i = 0; i < loops.size(); ++i) {
      EXPECT_EQ(loops[i].tool, 1U);
      EXPECT_NEAR(loops[i].bead.at(0).width_mm, nozzle_mm, 1e-12);
      // Outermost first, round a square from 0 to 40 mm.
      double farthest = 0.0;
      for (const Point3& point : loops[i].points) farthest = std::max(farthest, -point.x());
      EXPECT_NEAR(farthest, (static_cast<double>(loops.size() - i) - 0.5) * pitch, 1e-5) << nozzle_mm;
    }
  }
}

TEST(ToolBeads, OfRaftsFollowTheirOwnNozzle) {
  for (const double nozzle_mm : {0.35, 0.4, 0.8}) {
    PlanSettings settings = secondForAids(nozzle_mm);
    settings.adhesion.raft.layers = 4;
    const Toolpath toolpath = squareBy(settings);
    // 40 mm and a margin of 3 mm all round; two solid layers at the top, half as dense ones below.
    const double area_mm2 = 46.0 * 46.0;
    for (std::size_t l = 0; l < 4; ++l) {
      const std::vector<Path> raft = depositedAs(PathRole::Raft, toolpath.layers[l]);
      double deposited_mm3 = 0.0;
      for (const Path& path : raft) {
        EXPECT_EQ(path.tool, 1U);
        EXPECT_NEAR(path.bead.at(0).width_mm, nozzle_mm, 1e-12);
        deposited_mm3 += depositedVolume(path);
      }
      const double whole_mm3 = area_mm2 * (l == 0 ? 0.3 : kToolLayer);
      EXPECT_NEAR(deposited_mm3 / whole_mm3, l < 2 ? 0.5 : 1.0, 0.03) << nozzle_mm << " mm, layer " << l;
    }
  }
}

TEST(ToolBeads, OfBranchesAndSkirtsFollowTheirOwnNozzle) {
  const auto slab = [](int l) {
    return std::vector<Polygon>{l < 50 ? test::rectangle(-3, -3, 3, 3) : test::rectangle(-15, -15, 15, 15)};
  };
  for (const double nozzle_mm : {0.3, 0.6}) {
    PlanSettings settings = secondForAids(nozzle_mm);
    settings.skirt.count = 2;
    settings.supports.use = true;
    settings.supports.kind = SupportKind::Tree;
    settings.supports.tip_mm = 1.5;
    std::size_t count = 0;
    for (const ToolpathLayer& layer : test::plan(test::layersOf(60, slab), settings).layers) {
      for (const Path& path : depositedAs(PathRole::Support, layer)) {
        EXPECT_EQ(path.tool, 1U);
        EXPECT_NEAR(path.bead.at(0).width_mm, nozzle_mm, 1e-12);
        ++count;
      }
      for (const Path& path : depositedAs(PathRole::Skirt, layer)) {
        EXPECT_EQ(path.tool, 0U);
        EXPECT_NEAR(path.bead.at(0).width_mm, 0.4, 1e-12) << "the walls' tool lays the skirt";
      }
    }
    EXPECT_GT(count, 50U);
  }
}

TEST(ToolBeads, OfInterfacesAreThoseOfTheToolThatLaysThem) {
  PlanSettings settings = twoNozzles(0.4, 0.6);
  settings.tools.list["2.nozzle_mm"] = "0.8";
  settings.supports.interface_tool = 2;
  EXPECT_NEAR(beadOf(PathRole::SupportInterface, settings, kToolLayer).bead.width_mm, 0.8, 1e-12);
  settings.tools.support = 1;
  EXPECT_EQ(toolOf(PathRole::SupportInterface, settings), 1U) << "tool.support holds";
  EXPECT_NEAR(beadOf(PathRole::SupportInterface, settings, kToolLayer).bead.width_mm, 0.6, 1e-12);
}

TEST(ToolBeads, HaveTheWidthStatedForTheirRoleWhateverTheirTool) {
  PlanSettings settings = twoNozzles(0.4, 0.8);
  settings.infill.bead_width_mm = 0.5;
  settings.skins.bead_width_mm = 0.6;
  settings.supports.bead_width_mm = 0.7;
  const auto width = [&](PathRole role) { return beadOf(role, settings, kToolLayer).bead.width_mm; };
  EXPECT_NEAR(width(PathRole::Infill), 0.5, 1e-12);
  for (const PathRole role : {PathRole::Skin, PathRole::TopSkin, PathRole::BottomSkin})
    EXPECT_NEAR(width(role), 0.6, 1e-12);
  for (const PathRole role : {PathRole::Support, PathRole::SupportInterface})
    EXPECT_NEAR(width(role), 0.7, 1e-12);
  for (const PathRole role : {PathRole::OuterWall, PathRole::InnerWall, PathRole::Bridge, PathRole::Ironing,
                              PathRole::Brim, PathRole::Raft, PathRole::Skirt})
    EXPECT_NEAR(width(role), 0.4, 1e-12);
  EXPECT_NEAR(beadOf(PathRole::Infill, settings, kToolLayer).pitch_mm, 0.5 - (1.0 - M_PI / 4.0) * kToolLayer,
              1e-12);
  settings.bead.pitch_mm = 0.3;
  EXPECT_NEAR(beadOf(PathRole::Infill, settings, kToolLayer).pitch_mm, 0.3 * 0.5 / 0.4, 1e-12);
}

/// One tool, no skirt.
PlanSettings plainSquare() {
  PlanSettings settings;
  settings.skirt.count = 0;
  return settings;
}

double lengthAs(PathRole role, const Toolpath& toolpath) {
  double sum = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : depositedAs(role, layer))
      for (std::size_t i = 1; i < path.points.size(); ++i)
        sum += (path.points[i] - path.points[i - 1]).norm();
  return sum;
}

double volumeAs(PathRole role, const Toolpath& toolpath) {
  double sum = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : depositedAs(role, layer)) sum += depositedVolume(path);
  return sum;
}

TEST(ToolBeads, WiderBeadsOfInfillLayTheSameVolumeInLessLength) {
  PlanSettings settings = plainSquare();
  settings.infill.density = 0.2;
  settings.infill.links.link = LineLink::None;
  settings.infill.wall_overlap = 0.0;
  const Toolpath usual = squareBy(settings);
  for (const double width_mm : {0.45, 0.6}) {
    settings.infill.bead_width_mm = width_mm;
    const Toolpath wide = squareBy(settings);
    const double edge = (1.0 - M_PI / 4.0) * kToolLayer;
    EXPECT_NEAR(volumeAs(PathRole::Infill, wide) / volumeAs(PathRole::Infill, usual), 1.0, 0.02) << width_mm;
    EXPECT_NEAR(lengthAs(PathRole::Infill, wide) / lengthAs(PathRole::Infill, usual),
                (0.4 - edge) / (width_mm - edge), 0.02)
        << width_mm;
    EXPECT_EQ(volumeAs(PathRole::OuterWall, wide), volumeAs(PathRole::OuterWall, usual));
  }
}

TEST(ToolBeads, WiderBeadsOfSkinsFillThemExactly) {
  PlanSettings settings = plainSquare();
  settings.skins.top_layers = settings.skins.bottom_layers = 10;
  const Toolpath usual = squareBy(settings);
  settings.skins.bead_width_mm = 0.5;
  const Toolpath wide = squareBy(settings);
  const auto skins = [](const Toolpath& toolpath) {
    return volumeAs(PathRole::TopSkin, toolpath) + volumeAs(PathRole::Skin, toolpath) +
           volumeAs(PathRole::BottomSkin, toolpath);
  };
  const double inside_mm = 40.0 - 2.0 * (0.2 + 1.5 * (0.4 - (1.0 - M_PI / 4.0) * kToolLayer));
  EXPECT_NEAR(skins(usual) / (20 * kToolLayer * inside_mm * inside_mm), 1.0, 0.01);
  EXPECT_NEAR(skins(wide) / skins(usual), 1.0, 0.005);
  EXPECT_LT(lengthAs(PathRole::Skin, wide), 0.85 * lengthAs(PathRole::Skin, usual));
}

TEST(ToolBeads, StatedWidthsOfWallsChangeNothing) {
  PlanSettings settings = plainSquare();
  settings.skins.top_layers = settings.skins.bottom_layers = 2;
  const Toolpath before = squareBy(settings);
  settings.infill.bead_width_mm = settings.skins.bead_width_mm = settings.bead.width_mm;
  const Toolpath after = squareBy(settings);
  ASSERT_EQ(before.layers.size(), after.layers.size());
  for (std::size_t l = 0; l < before.layers.size(); ++l) {
    ASSERT_EQ(before.layers[l].paths.size(), after.layers[l].paths.size());
    for (std::size_t p = 0; p < before.layers[l].paths.size(); ++p)
      EXPECT_EQ(before.layers[l].paths[p].points, after.layers[l].paths[p].points);
  }
}

TEST(ToolBeads, StatedWidthsBelowTheLayersHeightAreRefused) {
  PlanSettings settings = plainSquare();
  settings.skins.bead_width_mm = 0.15;
  try {
    squareBy(settings);
    FAIL() << "taken";
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("skins.bead_width_mm is 0.15 mm; must be 0 or at least 0.2 mm"),
              std::string::npos)
        << error.what();
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
