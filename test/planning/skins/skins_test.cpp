// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Solid layers where a part is seen from above or below.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <map>
#include <set>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/planning/skins/layer_cover.hpp"
#include "planning/skins/skin_areas.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::plan;
using test::rectangle;

constexpr double kSkinBeadWidth = 0.4;    // mm, of a bead
constexpr double kSkinLayerHeight = 0.2;  // mm
const double kSkinPitch = kSkinBeadWidth - (1.0 - 0.25 * M_PI) * kSkinLayerHeight;
const double kWalls = 0.5 * kSkinBeadWidth + 1.5 * kSkinPitch;  // thickness of two

PlanSettings fourAndFour() {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.infill.density = 0.15;
  settings.skins.top_layers = settings.skins.bottom_layers = 4;
  return settings;
}

double depositedBy(const ToolpathLayer& layer, PathRole role) {
  double sum = 0.0;
  for (const Path& path : layer.paths)
    if (path.role == role) sum += depositedVolume(path);
  return sum;
}

double depositedBy(const Toolpath& toolpath, PathRole role) {
  double sum = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers) sum += depositedBy(layer, role);
  return sum;
}

double solidVolumeOf(const ToolpathLayer& layer) {
  return depositedBy(layer, PathRole::TopSkin) + depositedBy(layer, PathRole::Skin) +
         depositedBy(layer, PathRole::BottomSkin);
}

Polygon centredSquare(double side) { return rectangle(-0.5 * side, -0.5 * side, 0.5 * side, 0.5 * side); }

/// Squares of 40, 30, 20 and 10 mm, 20 layers each.
std::vector<Layer> steppedPyramid() {
  return test::layersOf(80, [](int l) {
    const int step = l / 20;
    return std::vector<Polygon>{centredSquare(40.0 - 10.0 * step)};
  });
}

TEST(Skins, CloseACubeAboveAndBelow) {
  const auto layers = test::layersOf(100, [](int) { return std::vector<Polygon>{centredSquare(20)}; });
  const Toolpath toolpath = plan(layers, fourAndFour());
  const double of_layer = std::pow(20 - 2 * kWalls, 2) * kSkinLayerHeight;  // 68.66 mm3
  EXPECT_NEAR(depositedBy(toolpath, PathRole::TopSkin), of_layer, 0.003 * of_layer);
  EXPECT_NEAR(depositedBy(toolpath, PathRole::BottomSkin), of_layer, 0.003 * of_layer);
  EXPECT_NEAR(depositedBy(toolpath, PathRole::Skin), 6 * of_layer, 0.003 * 6 * of_layer);
  for (std::size_t l = 0; l < 100; ++l)
    EXPECT_EQ(solidVolumeOf(toolpath.layers[l]) > 0.0, l < 4 || l >= 96) << l;
  EXPECT_GT(depositedBy(toolpath.layers[0], PathRole::BottomSkin), 0.0);
  EXPECT_GT(depositedBy(toolpath.layers[99], PathRole::TopSkin), 0.0);
  double solid = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers) solid += solidVolumeOf(layer);
  EXPECT_NEAR(solid, 549.30, 0.003 * 549.30);
  // Two loops of 4 (20 - 0.4) and 4 (20 - 0.4 - 2 pitches) mm a layer.
  EXPECT_NEAR(depositedBy(toolpath, PathRole::OuterWall) + depositedBy(toolpath, PathRole::InnerWall), 1099.4,
              0.003 * 1099.4);
}

TEST(Skins, LeaveTheSparseLayersBetweenAsTheyWere) {
  const auto layers = test::layersOf(100, [](int) { return std::vector<Polygon>{centredSquare(20)}; });
  PlanSettings without = fourAndFour();
  without.skins = SkinSettings{};
  const Toolpath skinned = plan(layers, fourAndFour());
  const Toolpath plain = plan(layers, without);
  for (std::size_t l = 4; l < 96; ++l)
    EXPECT_DOUBLE_EQ(depositedBy(skinned.layers[l], PathRole::Infill),
                     depositedBy(plain.layers[l], PathRole::Infill))
        << l;
}

/// A skin of a solid infill is that infill by another name.
TEST(Skins, GiveASolidInfillTheirRoles) {
  PlanSettings solid = fourAndFour();
  solid.infill.density = 1.0;
  PlanSettings without = solid;
  without.skins = SkinSettings{};
  const auto layers = test::layersOf(20, [](int) { return std::vector<Polygon>{centredSquare(20)}; });
  const Toolpath skinned = plan(layers, solid);
  const Toolpath plain = plan(layers, without);
  for (std::size_t l = 0; l < 20; ++l) {
    const PathRole role = l == 0             ? PathRole::BottomSkin
                          : l == 19          ? PathRole::TopSkin
                          : l < 4 || l >= 16 ? PathRole::Skin
                                             : PathRole::Infill;
    const double deposited = depositedBy(plain.layers[l], PathRole::Infill);
    EXPECT_NEAR(depositedBy(skinned.layers[l], role), deposited, 0.003 * deposited) << l;
    EXPECT_NEAR(depositedBy(skinned.layers[l], PathRole::Infill), role == PathRole::Infill ? deposited : 0.0,
                1e-9);
  }
  solid.infill.strategy = "hilbert";
  EXPECT_EQ(depositedBy(plan(layers, solid), PathRole::TopSkin), 0.0) << "a curve is not cut";
}

TEST(Skins, GiveSolidOuterLayersTheirRoles) {
  PlanSettings settings = fourAndFour();
  settings.infill.outer_layers = 2;
  const auto layers = test::layersOf(20, [](int) { return std::vector<Polygon>{centredSquare(20)}; });
  const Toolpath toolpath = plan(layers, settings);
  const double of_layer = std::pow(20 - 2 * kWalls, 2) * kSkinLayerHeight;
  EXPECT_NEAR(depositedBy(toolpath.layers[0], PathRole::BottomSkin), of_layer, 0.01 * of_layer);
  EXPECT_NEAR(depositedBy(toolpath.layers[1], PathRole::Skin), of_layer, 0.01 * of_layer);
  EXPECT_NEAR(depositedBy(toolpath.layers[19], PathRole::TopSkin), of_layer, 0.01 * of_layer);
}

TEST(Skins, ShareOutASolidLayerWithASeenRim) {
  PlanSettings solid = fourAndFour();
  solid.infill.density = 1.0;
  const Toolpath toolpath = plan(steppedPyramid(), solid);
  const double ring = (std::pow(40 - 2 * kWalls, 2) - std::pow(30 - 2 * kWalls, 2)) * kSkinLayerHeight;
  const double rest = std::pow(30 - 2 * kWalls, 2) * kSkinLayerHeight;
  EXPECT_NEAR(depositedBy(toolpath.layers[19], PathRole::TopSkin), ring, 0.015 * ring);
  EXPECT_NEAR(depositedBy(toolpath.layers[19], PathRole::Infill), rest, 0.015 * rest);
  EXPECT_NEAR(depositedBy(toolpath.layers[18], PathRole::Skin), ring, 0.015 * ring);
}

TEST(Skins, TurnByAQuarterFromLayerToLayer) {
  const auto layers = test::layersOf(4, [](int) { return std::vector<Polygon>{centredSquare(20)}; });
  const Toolpath toolpath = plan(layers, fourAndFour());
  for (std::size_t l = 0; l < 4; ++l) {
    double along = 0.0;
    double across = 0.0;
    for (const Path& path : toolpath.layers[l].paths) {
      if (kindOf(path.role) != RoleKind::Infill) continue;
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        const Point3 way = path.points[path.motionEnd(m)] - path.points[m];
        along += std::abs(way.x() + way.y());
        across += std::abs(way.x() - way.y());
      }
    }
    EXPECT_EQ(along > 5 * across, l % 2 == 0) << "45 deg, then 135 deg";
    EXPECT_EQ(across > 5 * along, l % 2 == 1);
  }
}

TEST(Skins, CoverTheStepsOfAPyramid) {
  const Toolpath toolpath = plan(steppedPyramid(), fourAndFour());
  // A ring reaches from the walls of its layer to under the walls of the step above.
  const double s = kWalls;
  const auto square = [](double side) { return side * side; };
  const std::map<std::size_t, double> areas = {{19, square(40 - 2 * s) - square(30 - 2 * s)},
                                               {39, square(30 - 2 * s) - square(20 - 2 * s)},
                                               {59, square(20 - 2 * s) - square(10 - 2 * s)},
                                               {79, square(10 - 2 * s)}};
  double sum = 0.0;
  double wanted = 0.0;
  for (const auto& [top, area] : areas)
    for (std::size_t l = top - 3; l <= top; ++l) {
      // Lines in a narrow ring are joined along its border more often than in a wide one.
      EXPECT_NEAR(solidVolumeOf(toolpath.layers[l]), area * kSkinLayerHeight, 0.015 * area * kSkinLayerHeight)
          << l;
      sum += solidVolumeOf(toolpath.layers[l]);
      wanted += area * kSkinLayerHeight;
    }
  EXPECT_NEAR(wanted, 1187.57, 0.01) << "670.575, 470.575, 270.575 and 72.740 mm2, four layers each";
  EXPECT_NEAR(sum, wanted, 0.003 * wanted);
  for (std::size_t l = 0; l < 4; ++l) sum += solidVolumeOf(toolpath.layers[l]);
  EXPECT_NEAR(sum, 2375.14, 0.003 * 2375.14) << "with the bottom";
  EXPECT_NEAR(depositedBy(toolpath.layers[19], PathRole::TopSkin), areas.at(19) * kSkinLayerHeight,
              0.003 * areas.at(19) * kSkinLayerHeight);
  EXPECT_EQ(depositedBy(toolpath.layers[18], PathRole::TopSkin), 0.0);
  EXPECT_EQ(solidVolumeOf(toolpath.layers[15]), 0.0);
  EXPECT_EQ(solidVolumeOf(toolpath.layers[20]), 0.0) << "the step above rests on it";
}

TEST(Skins, EndAtTheStepWithoutAnchor) {
  PlanSettings settings = fourAndFour();
  settings.skins.anchor_mm = 0.0;
  const Toolpath toolpath = plan(steppedPyramid(), settings);
  const double area = std::pow(40 - 2 * kWalls, 2) - 900.0;  // 584.47 mm2
  EXPECT_NEAR(solidVolumeOf(toolpath.layers[19]), area * kSkinLayerHeight, 0.003 * area * kSkinLayerHeight);
}

/// A prism whose square grows by a lean of its walls.
std::vector<Layer> leaning(double lean_deg) {
  const double step = kSkinLayerHeight * std::tan(lean_deg * M_PI / 180.0);
  return test::layersOf(60,
                        [step](int l) { return std::vector<Polygon>{centredSquare(60.0 - 2.0 * step * l)}; });
}

TEST(Skins, MakeNoRingsOfWallsThatLeanALittle) {
  // A ring is left of the walls and a bead once 4 layers lean by more than both: 54.8 deg.
  for (const double lean_deg : {20.0, 50.0, 60.0}) {
    const Toolpath toolpath = plan(leaning(lean_deg), fourAndFour());
    double between = 0.0;
    for (std::size_t l = 4; l < 56; ++l) between += solidVolumeOf(toolpath.layers[l]);
    EXPECT_EQ(between > 0.0, lean_deg > 54.8) << lean_deg;
    for (const std::size_t l : {0U, 1U, 2U, 3U, 56U, 57U, 58U, 59U})
      EXPECT_GT(solidVolumeOf(toolpath.layers[l]), 0.0) << l;
  }
}

/// Area on which nothing solid lies, within walls and where one of the next three layers does not cover it.
double openArea(const std::vector<Layer>& layers, const Toolpath& toolpath, std::size_t l) {
  const Regions covered = unite(layers[l + 3].section.contours);
  Regions open = difference(unite(layers[l].section.contours), covered);
  std::vector<Polygon> beads;
  for (const Path& path : toolpath.layers[l].paths) {
    if (kindOf(path.role) != RoleKind::Wall && kindOf(path.role) != RoleKind::Infill) continue;
    if (path.role == PathRole::Infill) continue;
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t end = path.motionEnd(m);
      const Point2 from = path.points[m].head<2>();
      const Point2 to = path.points[end].head<2>();
      const double half = 0.5 * path.bead.at(end).width_mm;
      const Point2 along = half * (to - from).normalized();
      const Point2 aside(-along.y(), along.x());
      beads.push_back({from - along - aside, to + along - aside, to + along + aside, from - along + aside});
    }
  }
  for (const Polygon& bead : beads) open = difference(open, unite({bead}));
  return area(open);
}

TEST(Skins, ThickenWallsWhoseSkinWouldBeTooNarrow) {
  // Two walls of 0.736 mm end three layers below a face that leans by more than 50.8 deg.
  for (const double lean_deg : {52.0, 54.0}) {
    const auto layers = leaning(lean_deg);
    const Toolpath toolpath = plan(layers, fourAndFour());
    // 6 and 16 mm2 without; the ends of beads leave a hundredth of a square millimetre in each corner.
    EXPECT_LT(openArea(layers, toolpath, 30), 0.04) << lean_deg;
    double inner = 0.0;
    for (const Path& path : toolpath.layers[30].paths)
      if (path.role == PathRole::InnerWall) inner += depositedVolume(path);
    double loops = 0.0;
    for (const Path& path : toolpath.layers[30].paths)
      if (path.role == PathRole::OuterWall) loops += depositedVolume(path);
    // One bead more, of what is seen and half a bead: 0.4 to 0.6 mm.
    EXPECT_GT(inner, 1.8 * loops) << lean_deg;
    EXPECT_LT(inner, 2.8 * loops) << lean_deg;
  }
}

TEST(Skins, LeaveWallsThatCoverTheirFace) {
  for (const double lean_deg : {20.0, 44.0}) {
    const Toolpath toolpath = plan(leaning(lean_deg), fourAndFour());
    std::size_t loops = 0;
    for (const Path& path : toolpath.layers[30].paths) loops += kindOf(path.role) == RoleKind::Wall ? 1 : 0;
    EXPECT_EQ(loops, 2U) << lean_deg;
  }
}

TEST(Skins, FindARoofOfOneLayer) {
  // A cube with a void from layer 10 to 29, in which layer 20 alone spans all.
  const auto layers = test::layersOf(40, [](int l) {
    std::vector<Polygon> contours{centredSquare(30)};
    const bool is_void = l >= 10 && l < 30 && l != 20;
    if (is_void) contours.push_back(test::reversed(centredSquare(20)));
    return contours;
  });
  const Toolpath toolpath = plan(layers, fourAndFour());
  const double roof = std::pow(20 + 2 * kWalls, 2) * kSkinLayerHeight;
  EXPECT_NEAR(solidVolumeOf(toolpath.layers[20]), roof, 0.003 * roof);
  EXPECT_EQ(solidVolumeOf(toolpath.layers[19]), 0.0);
  EXPECT_EQ(solidVolumeOf(toolpath.layers[21]), 0.0);
  for (const std::size_t l : {6U, 7U, 8U, 9U, 30U, 31U, 32U, 33U})
    EXPECT_GT(solidVolumeOf(toolpath.layers[l]), 0.0) << l;
}

TEST(Skins, AreAsThickAsAskedInThinLayers) {
  PlanSettings settings = fourAndFour();
  settings.skins.top_layers = 1;
  settings.skins.bottom_layers = 1;
  settings.skins.top_mm = 1.0;
  settings.skins.bottom_mm = 0.59;
  const auto layers = test::layersOf(30, [](int) { return std::vector<Polygon>{centredSquare(20)}; });
  const Toolpath toolpath = plan(layers, settings);
  for (std::size_t l = 0; l < 30; ++l)
    EXPECT_EQ(solidVolumeOf(toolpath.layers[l]) > 0.0, l < 3 || l >= 25) << l;
}

TEST(Skins, TakeTheirFeedsByRole) {
  PlanSettings settings = fourAndFour();
  settings.feed.first_layer_mm_s = 1000.0;
  const auto layers = test::layersOf(20, [](int) { return std::vector<Polygon>{centredSquare(20)}; });
  const std::map<PathRole, double> expected = {{PathRole::TopSkin, settings.feed.top_skin_mm_s},
                                               {PathRole::Skin, settings.feed.skin_mm_s},
                                               {PathRole::BottomSkin, settings.feed.skin_mm_s}};
  std::set<PathRole> seen;
  for (const ToolpathLayer& layer : plan(layers, settings).layers)
    for (const Path& path : layer.paths) {
      const auto skin = expected.find(path.role);
      if (skin == expected.end()) continue;
      EXPECT_EQ(path.feed_mm_s.at(1), skin->second) << toString(path.role);
      seen.insert(path.role);
    }
  EXPECT_EQ(seen.size(), expected.size());
}

TEST(Skins, RefuseAStrategyThatFillsNoLayerByItself) {
  const auto layers = test::layersOf(4, [](int) { return std::vector<Polygon>{centredSquare(20)}; });
  PlanSettings settings = fourAndFour();
  for (const char* strategy : {"drops_raster", "vase"}) {
    settings.skins.strategy = strategy;
    EXPECT_THROW(plan(layers, settings), InvalidConfig) << strategy;
  }
  settings.skins.strategy = "hilbert";
  EXPECT_NO_THROW(plan(layers, settings));
}

TEST(Skins, AreTheSameForAnyNumberOfThreads) {
  std::string id;
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    const std::string now = toolpathId(plan(leaning(65.0), fourAndFour()));
    if (!id.empty()) {
      EXPECT_EQ(now, id);
    }
    id = now;
  }
}

double differenceArea(const Regions& a, const Regions& b) {
  return area(difference(a, b)) + area(difference(b, a));
}

/// What all layers from one to another have in common, one intersection after the other.
Regions commonOf(const std::vector<Regions>& layers, int from, int to) {
  if (from < 0 || to >= static_cast<int>(layers.size())) return {};
  Regions common = layers[static_cast<std::size_t>(from)];
  for (int l = from + 1; l <= to; ++l) common = intersection(common, layers[static_cast<std::size_t>(l)]);
  return common;
}

TEST(LayerCover, EqualsDirectIntersections) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    std::vector<Regions> layers;
    const std::size_t count = 1 + random.below(150);
    for (std::size_t l = 0; l < count; ++l) {
      if (l > 0 && random.below(2) == 0) {
        layers.push_back(layers.back());
        continue;
      }
      std::vector<Polygon> squares;
      for (std::size_t i = random.below(3); i > 0; --i) {
        const double x = random.uniform(-5, 5);
        const double y = random.uniform(-5, 5);
        squares.push_back(rectangle(x, y, x + random.uniform(5, 20), y + random.uniform(5, 20)));
      }
      layers.push_back(unite(squares));
    }
    SkinSettings settings;
    settings.top_layers = 1 + static_cast<int>(random.below(9));
    settings.bottom_layers = random.below(2) == 0 ? settings.top_layers : static_cast<int>(random.below(9));
    NoProgress nobody;
    const auto covers = coversOf(layers, std::vector<double>(count, 0.2), settings, nobody);
    for (int l = 0; l < static_cast<int>(count); ++l) {
      const LayerCover& cover = covers[static_cast<std::size_t>(l)];
      const Regions& own = layers[static_cast<std::size_t>(l)];
      const Regions above = commonOf(layers, l + 1, l + settings.top_layers);
      const Regions below =
          settings.bottom_layers == 0 ? own : commonOf(layers, l - settings.bottom_layers, l - 1);
      RC_ASSERT(differenceArea(*cover.whole, intersection(above, below)) <= 1e-6 * area(own));
    }
  }));
}

TEST(SkinAreas, ShareOutTheWholeAreaOnce) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    const auto anySquare = [&random] {
      const double x = random.uniform(-12, 8);
      const double y = random.uniform(-12, 8);
      return std::make_shared<const Regions>(
          unite({rectangle(x, y, x + random.uniform(2, 20), y + random.uniform(2, 20))}));
    };
    const LayerCover cover{anySquare(), anySquare(), anySquare(), anySquare()};
    const Regions inside = unite({centredSquare(20)});
    const SkinAreas areas = skinAreas(
        inside, cover,
        {random.uniform(0, 1), random.uniform(0, 2), random.uniform(0, 30), random.uniform(0, 0.3), 0.4});
    double sum = 0.0;
    std::vector<Polygon> all;
    for (const Regions* part :
         {&areas.bottom_skin, &areas.skin, &areas.top_skin, &areas.thickening, &areas.sparse}) {
      sum += area(*part);
      for (const Polygon& outline : outlines(*part)) all.push_back(outline);
    }
    RC_ASSERT(std::abs(sum - 400.0) < 1e-2);
    RC_ASSERT(differenceArea(unite(all), inside) < 1e-2);
  }));
}

}  // namespace
}  // namespace lamina
