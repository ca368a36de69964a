// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/skins/ironing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

const double kIronedWalls = 0.2 + 1.5 * test::kLayerPitch;  // mm, of two

std::vector<Layer> ironedCube() {
  return test::layersOf(12, [](int) { return std::vector<Polygon>{test::rectangle(0, 0, 20, 20)}; });
}

PlanSettings ironed() {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.skins.top_layers = settings.skins.bottom_layers = 3;
  settings.ironing.is_used = true;
  return settings;
}

double depositedInRole(const ToolpathLayer& layer, PathRole role) {
  double sum = 0.0;
  for (const Path& path : layer.paths)
    if (path.role == role) sum += depositedVolume(path);
  return sum;
}

TEST(Ironing, LaysItsShareOverWhatIsSeen) {
  const Toolpath toolpath = test::plan(ironedCube(), ironed());
  const double side = 20.0 - 2.0 * kIronedWalls - 2.0 * 0.2;  // walls and inset
  const double volume = 0.15 * 0.2 * side * side;             // flow, layer height
  EXPECT_NEAR(depositedInRole(toolpath.layers[11], PathRole::Ironing), volume, 0.015 * volume);
  for (std::size_t l = 0; l < 11; ++l)
    EXPECT_EQ(depositedInRole(toolpath.layers[l], PathRole::Ironing), 0.0) << l;
}

TEST(Ironing, IsTheLastThingInItsLayer) {
  const Toolpath toolpath = test::plan(ironedCube(), ironed());
  bool has_begun = false;
  for (const Path& path : toolpath.layers[11].paths) {
    if (path.role == PathRole::Ironing) {
      has_begun = true;
      EXPECT_EQ(path.feed_mm_s.at(1), 20.0);
      EXPECT_NEAR(crossSection(path.bead.at(1)), 0.15 * 0.1 * 0.2, 1e-12) << "flow, spacing, layer height";
      EXPECT_NEAR(path.bead.at(1).height_mm, 0.2, 1e-12);
    }
    if (has_begun) {
      EXPECT_TRUE(path.role == PathRole::Ironing || path.role == PathRole::Travel) << toString(path.role);
    }
  }
  EXPECT_TRUE(has_begun);
}

TEST(Ironing, CrossesTheLinesOfTheSkin) {
  const Toolpath toolpath = test::plan(ironedCube(), ironed());
  for (const Path& path : toolpath.layers[11].paths)
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const Point3 way = path.points[path.motionEnd(m)] - path.points[m];
      if (way.norm() < 2.0) continue;
      // Layer 11 is turned by 270 deg against the 45 deg of the first one.
      if (path.role == PathRole::TopSkin) {
        EXPECT_NEAR(way.x() + way.y(), 0.0, 1e-9);
      }
      if (path.role == PathRole::Ironing) {
        EXPECT_NEAR(way.x() - way.y(), 0.0, 1e-9);
      }
    }
}

TEST(Ironing, PassesOverSolidInfillToo) {
  PlanSettings settings = ironed();
  settings.infill.density = 1.0;
  const Toolpath toolpath = test::plan(ironedCube(), settings);
  EXPECT_GT(depositedInRole(toolpath.layers[11], PathRole::Ironing), 8.0);
  EXPECT_EQ(depositedInRole(toolpath.layers[10], PathRole::Ironing), 0.0);
}

TEST(Ironing, ChangesNothingElse) {
  PlanSettings settings = ironed();
  const Toolpath with = test::plan(ironedCube(), settings);
  settings.ironing.is_used = false;
  const Toolpath without = test::plan(ironedCube(), settings);
  for (std::size_t l = 0; l < 12; ++l)
    for (const PathRole role : {PathRole::OuterWall, PathRole::InnerWall, PathRole::Infill, PathRole::TopSkin,
                                PathRole::Skin, PathRole::BottomSkin})
      EXPECT_DOUBLE_EQ(depositedInRole(with.layers[l], role), depositedInRole(without.layers[l], role));
}

TEST(Ironing, IsRefusedWhereNothingIsSeenAsSkin) {
  PlanSettings settings = ironed();
  settings.skins.top_layers = 0;
  EXPECT_THROW(test::plan(ironedCube(), settings), InvalidConfig);
}

TEST(Ironing, OfWhatIsNarrowerThanTwiceTheInsetIsNone) {
  IroningSettings settings;
  settings.inset_mm = 0.5;
  EXPECT_TRUE(ironingLines({{test::rectangle(0, 0, 20, 0.9), {}}}, settings, 0.0).empty());
  EXPECT_FALSE(ironingLines({{test::rectangle(0, 0, 20, 1.5), {}}}, settings, 0.0).empty());
}

}  // namespace
}  // namespace lamina
