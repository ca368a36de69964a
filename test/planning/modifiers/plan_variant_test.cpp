// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Settings that hold in part of a layer.
#include "lamina/planning/modifiers/plan_variant.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/infill/line_link.hpp"
#include "lamina/voids/beads/void_map.hpp"
#include "planning/modifiers/run_clipping.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

constexpr int kVariedLayers = 100;

std::vector<Layer> cube() {
  return test::layersOf(kVariedLayers, [](int) { return std::vector<Polygon>{rectangle(0, 0, 20, 20)}; });
}

/// Lines that are not joined, so that the volume is the density's.
PlanSettings sparse(double density) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.infill.density = density;
  settings.infill.links.link = LineLink::None;
  settings.infill.wall_overlap = 0.0;
  return settings;
}

PlanVariant variantOf(const PlanSettings& settings, const Regions& area, int from = 0,
                      int to = kVariedLayers) {
  PlanVariant variant{settings, std::vector<Regions>(kVariedLayers)};
  for (int i = from; i < to; ++i) variant.areas[static_cast<std::size_t>(i)] = area;
  return variant;
}

Toolpath variedPlan(const PlanSettings& settings, const std::vector<PlanVariant>& variants) {
  NoProgress nobody;
  const Box2 bed{{-100.0, -100.0}, {100.0, 100.0}};
  Toolpath toolpath = planPart("part", cube(), settings, VariedBed{bed, variants}, nobody).toolpath;
  validate(toolpath);
  return toolpath;
}

const Regions kRightHalf = {Region{rectangle(10, -1, 21, 21), {}}};

/// Of paths whose middle lies right of that x.
double volumeBeyond(const Toolpath& toolpath, double x, RoleKind kind) {
  double sum_mm3 = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      if (kindOf(path.role) != kind) continue;
      Point3 middle = Point3::Zero();
      for (const Point3& point : path.points) middle += point / static_cast<double>(path.points.size());
      if (middle.x() > x) sum_mm3 += depositedVolume(path);
    }
  return sum_mm3;
}

double volume(const Toolpath& toolpath, RoleKind kind) { return volumeBeyond(toolpath, -1e9, kind); }

TEST(PlanVariant, FillsEachHalfByItsDensity) {
  const Toolpath toolpath = variedPlan(sparse(0.15), {variantOf(sparse(0.6), kRightHalf)});
  const double right = volumeBeyond(toolpath, 10, RoleKind::Infill);
  const double left = volume(toolpath, RoleKind::Infill) - right;
  EXPECT_NEAR(right / left, 4.0, 0.08);
  // Lines end half a bead inside their place: a little less at borders than the density asks for.
  EXPECT_NEAR(right, 0.5 * volume(test::plan(cube(), sparse(0.6)), RoleKind::Infill), 0.04 * right);
  EXPECT_NEAR(volume(toolpath, RoleKind::Wall), volume(test::plan(cube(), sparse(0.15)), RoleKind::Wall),
              1e-6);
}

TEST(PlanVariant, LeavesNothingOpenBetweenSolidHalves) {
  PlanSettings solid;
  solid.skirt.count = 0;
  solid.infill.density = 1.0;
  PlanSettings across = solid;
  across.infill.angle_deg += 30.0;
  const Toolpath toolpath = variedPlan(solid, {variantOf(across, kRightHalf)});
  for (const std::size_t l : {4U, 5U}) {
    const LayerVoids found = findVoids({Region{rectangle(0, 0, 20, 20), {}}}, toolpath.layers[l], {});
    for (const Void& each : found.voids) {
      Box2 box;
      for (const Point2& point : each.outline.outer) box.include(point);
      if (box.high.x() < 9.0 || box.low.x() > 11.0) continue;
      // Where lines turn back there are gaps between them as beside walls; none goes along the border.
      EXPECT_LT(box.size().y(), 2.0 * test::kLayerPitch) << l;
      EXPECT_LT(each.area_mm2, 0.3 * test::kLayerPitch * test::kLayerPitch) << l;
    }
  }
}

TEST(PlanVariant, OfWholeLayersIsTheirPlan) {
  const Toolpath dense = test::plan(cube(), sparse(0.6));
  const Toolpath light = test::plan(cube(), sparse(0.15));
  const Regions all = {Region{rectangle(-1, -1, 21, 21), {}}};
  const Toolpath toolpath = variedPlan(sparse(0.15), {variantOf(sparse(0.6), all, 40, 60)});
  for (std::size_t i = 0; i < toolpath.layers.size(); ++i) {
    const Toolpath& same = i >= 40 && i < 60 ? dense : light;
    EXPECT_NEAR(totals({"", {toolpath.layers[i]}, Eigen::Quaterniond::Identity(), {}}).deposited_mm3,
                totals({"", {same.layers[i]}, Eigen::Quaterniond::Identity(), {}}).deposited_mm3, 1e-9)
        << i;
  }
}

TEST(PlanVariant, WithoutAreaChangesNothing) {
  const Toolpath toolpath = variedPlan(sparse(0.15), {variantOf(sparse(0.6), {})});
  EXPECT_EQ(toolpathId(toolpath), toolpathId(test::plan(cube(), sparse(0.15))));
}

TEST(PlanVariant, EndsInnerWallsAtItsBorder) {
  PlanSettings four = sparse(0.0);
  four.walls.count = 4;
  const Toolpath toolpath = variedPlan(sparse(0.0), {variantOf(four, kRightHalf)});
  const double section = crossSection({0.4, 0.2});
  double expected_mm = 0.0;
  for (int k = 0; k < 4; ++k) {
    const double side = 20.0 - 2.0 * (0.2 + k * test::kLayerPitch);
    expected_mm += k < 2 ? 4.0 * side : 2.0 * side;  // loops, and halves of two more
  }
  EXPECT_NEAR(volume(toolpath, RoleKind::Wall), expected_mm * section * kVariedLayers,
              1e-4 * expected_mm * section * kVariedLayers);
  for (const Path& path : toolpath.layers[0].paths) {
    if (kindOf(path.role) != RoleKind::Wall || path.is_closed) continue;
    for (const Point3& point : path.points) EXPECT_GE(point.x(), 10.0 - 1e-6);
  }
}

/// Both fills run over the border between them, where neither leaves anything to be filled.
TEST(PlanVariant, IsNotRefilledWhereSparseFillsOverlap) {
  PlanSettings light = sparse(0.15);
  light.infill.wall_overlap = 0.9;
  light.voids.refill = VoidRefill::Beads;
  PlanSettings dense = light;
  dense.infill.density = 0.3;
  const Regions slanted = {Region{{{8, -1}, {21, -1}, {21, 21}, {12, 21}}, {}}};
  NoProgress nobody;
  const std::vector<Layer> layers = {cube().front()};
  std::vector<PlanVariant> variants = {variantOf(dense, slanted)};
  const Box2 bed{{-100.0, -100.0}, {100.0, 100.0}};
  const Plan plan = planPart("part", layers, light, VariedBed{bed, variants}, nobody);
  EXPECT_EQ(plan.refilling.runs, 0U);
  EXPECT_EQ(plan.refilling.deposited_mm3, 0.0);
}

TEST(PlanVariant, ChangesFeedsOfWallsOnItsBorder) {
  PlanSettings slow = sparse(0.15);
  slow.feed.outer_wall_mm_s = 10.0;
  const Toolpath toolpath = variedPlan(sparse(0.15), {variantOf(slow, kRightHalf)});
  double slow_mm = 0.0;
  double usual_mm = 0.0;
  for (const Path& path : toolpath.layers[5].paths) {
    if (path.role != PathRole::OuterWall) continue;
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t end = path.motionEnd(m);
      const double length_mm = (path.points[end] - path.points[m]).norm();
      (path.feed_mm_s.at(end) == 10.0 ? slow_mm : usual_mm) += length_mm;
      const double middle = 0.5 * (path.points[end] + path.points[m]).x();
      EXPECT_EQ(path.feed_mm_s.at(end), middle > 10.0 ? 10.0 : 30.0);
    }
  }
  EXPECT_NEAR(slow_mm, 2 * 19.6, 1e-4);
  EXPECT_NEAR(usual_mm, 2 * 19.6, 1e-4);
}

TEST(PlanVariant, LaysLessByItsFlow) {
  PlanSettings solid = sparse(1.0);
  PlanSettings half = solid;
  half.bead.flow = 0.5;
  const Toolpath toolpath = variedPlan(solid, {variantOf(half, kRightHalf)});
  const double whole = totals(test::plan(cube(), solid)).deposited_mm3;
  EXPECT_NEAR(totals(toolpath).deposited_mm3, 0.75 * whole, 0.01 * whole);
  // The outer wall alone, whose waypoints are on the border.
  const auto outerWall = [](const Toolpath& of) {
    double sum_mm3 = 0.0;
    for (const Path& path : of.layers[5].paths)
      if (path.role == PathRole::OuterWall) sum_mm3 += depositedVolume(path);
    return sum_mm3;
  };
  const double usual = outerWall(test::plan(cube(), solid));
  EXPECT_NEAR(outerWall(toolpath), 0.75 * usual, 1e-6 * usual);
}

/// Whether the middle of a motion lies right of that x.
bool isRightOf(double x, const Path& path, std::size_t motion) {
  return 0.5 * (path.points[motion] + path.points[path.motionEnd(motion)]).x() > x;
}

TEST(PlanVariant, LaysByItsTools) {
  PlanSettings settings = sparse(0.3);
  settings.tools.list = {{"0.name", "black"}, {"1.name", "white"}};
  PlanSettings white = settings;
  white.tools.walls = white.tools.infill = white.tools.skin = 1;
  white.walls.count = 3;
  const Toolpath toolpath = variedPlan(settings, {variantOf(white, kRightHalf)});
  for (const ToolpathLayer& layer : toolpath.layers) {
    std::size_t changes = 0;
    for (std::size_t p = 0; p < layer.paths.size(); ++p) {
      const Path& path = layer.paths[p];
      if (p > 0 && layer.paths[p - 1].tool != path.tool) {
        ++changes;
        EXPECT_TRUE(path.role == PathRole::Travel && path.process.is_retracted);
      }
      if (path.role == PathRole::Travel) continue;
      for (std::size_t m = 0; m < path.motionCount(); ++m)
        EXPECT_EQ(path.tool, isRightOf(10.0, path, m) ? 1U : 0U);
    }
    EXPECT_EQ(changes, 1U);
  }
  PlanSettings three = settings;
  three.walls.count = 3;
  const Toolpath of_one = variedPlan(settings, {variantOf(three, kRightHalf)});
  EXPECT_NEAR(totals(toolpath).deposited_mm3, totals(of_one).deposited_mm3, 1e-6);
}

TEST(PlanVariant, PurgesWhereARegionTakesItsTool) {
  PlanSettings settings = sparse(0.3);
  settings.tools.list = {{"0.name", "black"}, {"1.name", "white"}};
  settings.tools.purge_mm3 = {40.0};
  PlanSettings white = settings;
  white.tools.infill = 1;
  const Toolpath toolpath = variedPlan(settings, {variantOf(white, kRightHalf, 3, 5)});
  for (std::size_t l = 0; l < 6; ++l) {
    double purged_mm3 = 0.0;
    for (const Path& path : toolpath.layers[l].paths)
      if (path.role == PathRole::Prime) purged_mm3 += depositedVolume(path);
    // There in layer 3, and back in layer 4; below it is kept by walls and a few lines.
    if (l < 3) {
      EXPECT_GT(purged_mm3, 4.0);
      EXPECT_LT(purged_mm3, 35.0);
    }
    if (l == 3 || l == 4) {
      EXPECT_NEAR(purged_mm3, 40.0, 0.4) << l;
    }
    if (l == 5) {
      EXPECT_EQ(purged_mm3, 0.0);
    }
  }
}

TEST(PlanVariant, HopsOverTopSkinsOfItsNeighbours) {
  // A band with a skin on top, amid lines that lie open.
  PlanSettings open = sparse(0.3);
  open.travel.hop = Hopping::OverSkin;
  open.travel.hop_mm = 0.5;
  PlanSettings closed = open;
  closed.skins.top_layers = 2;
  const Regions middle = {Region{rectangle(7, -1, 13, 21), {}}};
  const Toolpath toolpath = variedPlan(open, {variantOf(closed, middle)});
  const ToolpathLayer& top = toolpath.layers.back();
  std::size_t crossing = 0;
  bool is_skin_deposited = false;
  for (const Path& path : top.paths) {
    is_skin_deposited = is_skin_deposited || path.role == PathRole::TopSkin;
    if (!is_skin_deposited || path.role != PathRole::Travel) continue;
    const auto sideOf = [](const Point3& point) { return point.x() < 7.0 ? -1 : point.x() > 13.0 ? 1 : 0; };
    if (sideOf(path.firstPoint()) * sideOf(path.lastPoint()) >= 0) continue;
    ++crossing;
    EXPECT_EQ(path.points.size(), 4U);
    EXPECT_NEAR(path.points[1].z(), top.z_mm + 0.5, 1e-9);
  }
  EXPECT_EQ(crossing, 1U);
}

TEST(PlanVariant, LeavesWallsSlowWhereTheyOverhang) {
  // Each layer stands out by a bead over the one below, on all sides.
  const auto layers = test::layersOf(4, [](int i) {
    return std::vector<Polygon>{rectangle(-0.4 * i, -0.4 * i, 20 + 0.4 * i, 20 + 0.4 * i)};
  });
  PlanSettings usual = sparse(0.15);
  usual.overhangs.is_used = true;
  PlanSettings slow = usual;
  slow.feed.outer_wall_mm_s = 0.5 * usual.feed.outer_wall_mm_s;
  const PlanVariant right{slow, std::vector<Regions>(4, {Region{rectangle(10, -9, 30, 30), {}}})};
  NoProgress nobody;
  const Toolpath toolpath =
      planPart("part", layers, usual, VariedBed{{{-100, -100}, {100, 100}}, {right}}, nobody).toolpath;
  const double overhanging = usual.feed.outer_wall_mm_s * usual.overhangs.feed_factors.back();
  for (const Path& path : toolpath.layers[3].paths) {
    if (path.role != PathRole::OuterWall) continue;
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t end = path.motionEnd(m);
      const bool is_right = 0.5 * (path.points[end] + path.points[m]).x() > 10.0;
      EXPECT_LE(path.feed_mm_s.at(end), (is_right ? 0.5 : 1.0) * overhanging + 1e-9);
    }
  }
}

TEST(PlanVariant, HasSkinsOfItsOwn) {
  PlanSettings closed = sparse(0.15);
  closed.skins.top_layers = closed.skins.bottom_layers = 4;
  const Toolpath toolpath = variedPlan(sparse(0.15), {variantOf(closed, kRightHalf)});
  const double side = 20.0 - 2.0 * (0.2 + 1.5 * test::kLayerPitch);
  double skins_mm3 = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role == PathRole::TopSkin || path.role == PathRole::Skin || path.role == PathRole::BottomSkin)
        skins_mm3 += depositedVolume(path);
  EXPECT_NEAR(skins_mm3, 8 * 0.2 * 0.5 * side * side, 0.02 * skins_mm3);
}

TEST(PlanVariant, IsIronedByItsToolAndFeed) {
  PlanSettings settings = sparse(0.3);
  settings.skins.top_layers = 2;
  settings.ironing.is_used = true;
  settings.tools.list = {{"0.name", "black"}, {"1.name", "white"}};
  PlanSettings white = settings;
  white.tools.walls = white.tools.infill = white.tools.skin = 1;
  white.feed.ironing_mm_s = 7.0;
  white.bead.flow = 0.5;
  const auto ironed = [](const Toolpath& toolpath) {
    std::vector<Path> paths;
    for (const ToolpathLayer& layer : toolpath.layers)
      for (const Path& path : layer.paths)
        if (path.role == PathRole::Ironing) paths.push_back(path);
    return paths;
  };
  const auto volume_of = [](const std::vector<Path>& paths) {
    double sum_mm3 = 0.0;
    for (const Path& path : paths) sum_mm3 += depositedVolume(path);
    return sum_mm3;
  };
  const std::vector<Path> usual = ironed(variedPlan(settings, {}));
  const Regions all = {Region{rectangle(-1, -1, 21, 21), {}}};
  const std::vector<Path> whole = ironed(variedPlan(settings, {variantOf(white, all)}));
  ASSERT_FALSE(whole.empty());
  for (const Path& path : whole) {
    EXPECT_EQ(path.tool, 1U);
    EXPECT_EQ(path.feed_mm_s.at(1), 7.0);
  }
  EXPECT_NEAR(volume_of(whole), 0.5 * volume_of(usual), 1e-9);
  for (const Path& path : ironed(variedPlan(settings, {variantOf(white, kRightHalf)})))
    for (std::size_t m = 0; m < path.motionCount(); ++m)
      EXPECT_EQ(path.tool, isRightOf(10.0, path, m) ? 1U : 0U);
}

TEST(PlanVariant, HoldsForWallsOfAnIslandThatVariantsShare) {
  PlanSettings usual = sparse(0.15);
  PlanSettings rear = usual;
  rear.seam.placement = SeamPlacement::Rear;
  rear.walls.order = WallOrder::OutsideIn;
  PlanSettings dense = rear;
  dense.infill.density = 0.5;
  const Regions left = {Region{rectangle(-1, -1, 10, 21), {}}};
  const Toolpath toolpath =
      variedPlan(usual, {variantOf(rear, left, 10, 20), variantOf(dense, kRightHalf, 10, 20)});
  for (std::size_t l = 0; l < 30; ++l) {
    const std::vector<Path>& paths = toolpath.layers[l].paths;
    const auto walls_at = [&](PathRole role) {
      return std::find_if(paths.begin(), paths.end(), [role](const Path& path) { return path.role == role; });
    };
    const auto outer = walls_at(PathRole::OuterWall);
    ASSERT_NE(outer, paths.end());
    const bool holds = l >= 10 && l < 20;
    EXPECT_EQ(outer->firstPoint().y() > 19.0, holds) << l;
    EXPECT_EQ(outer < walls_at(PathRole::InnerWall), holds) << l;
  }
}

TEST(PlanVariant, HoldsForBeadsInGapsBetweenWalls) {
  // 1 mm wide: one loop, and 0.68 pitches within it.
  const auto layers = test::layersOf(2, [](int) { return std::vector<Polygon>{rectangle(0, 0, 20, 1)}; });
  PlanSettings settings = sparse(0.15);
  settings.tools.list = {{"0.name", "black"}, {"1.name", "white"}};
  PlanSettings white = settings;
  white.tools.walls = white.tools.infill = white.tools.skin = 1;
  white.bead.flow = 0.5;
  const auto gap_at = [&](const std::vector<PlanVariant>& variants, double x, std::uint32_t tool) {
    NoProgress nobody;
    const Box2 bed{{-100.0, -100.0}, {100.0, 100.0}};
    const Toolpath toolpath = planPart("part", layers, settings, VariedBed{bed, variants}, nobody).toolpath;
    double section_mm2 = 0.0;
    for (const Path& path : toolpath.layers[1].paths) {
      if (path.role != PathRole::GapFill) continue;
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        const double a = path.points[m].x();
        const double b = path.points[path.motionEnd(m)].x();
        if (std::min(a, b) > x || std::max(a, b) < x) continue;
        EXPECT_EQ(path.tool, tool);
        section_mm2 = crossSection(path.bead.at(path.motionEnd(m)));
      }
    }
    return section_mm2;
  };
  const PlanVariant right{white, std::vector<Regions>(2, kRightHalf)};
  const double usual_mm2 = gap_at({}, 15.0, 0);
  ASSERT_GT(usual_mm2, 0.0);
  EXPECT_NEAR(gap_at({right}, 15.0, 1), 0.5 * usual_mm2, 1e-9);
  EXPECT_NEAR(gap_at({right}, 5.0, 0), usual_mm2, 1e-9);
}

TEST(PlanVariant, RefusesAnotherFlowWhereVoidsAreRefilled) {
  PlanSettings settings = sparse(1.0);
  settings.voids.refill = VoidRefill::Beads;
  PlanSettings half = settings;
  half.bead.flow = 0.5;
  EXPECT_THROW(variedPlan(settings, {variantOf(half, kRightHalf)}), InvalidConfig);
}

TEST(PlanVariant, RefusesFillsThatLeaveTheirLayer) {
  PlanSettings chained = sparse(0.15);
  chained.infill.strategy = "contour";
  EXPECT_THROW(variedPlan(sparse(0.15), {variantOf(chained, kRightHalf)}), InvalidConfig);
  EXPECT_THROW(variedPlan(chained, {variantOf(sparse(0.15), kRightHalf)}), InvalidConfig);
}

TEST(RunClipping, KeepsWhatLiesInside) {
  EXPECT_TRUE(rc::check("pieces inside and outside make up the run", [](std::uint64_t seed) {
    Random random(seed);
    const Polygon loop = test::star(random, {0, 0}, 3, 10, 12);
    const Regions area = unite({test::star(random, {4, 1}, 2, 9, 9)});
    const Regions beyond = difference({Region{rectangle(-30, -30, 30, 30), {}}}, area);
    const FillPath run{loop, seed % 2 == 0, PathRole::InnerWall, Deposit::Bead, {}};
    double sum_mm = 0.0;
    for (const Regions& part : {area, beyond})
      for (const FillPath& piece : clipped(run, part))
        sum_mm += piece.is_closed ? perimeter(piece.points) : length(piece.points);
    const double whole_mm = run.is_closed ? perimeter(loop) : length(loop);
    RC_ASSERT(std::abs(sum_mm - whole_mm) < 0.02);
  }));
}

TEST(RunClipping, LeavesNoSeamWhereALoopBegan) {
  const FillPath run{rectangle(0, 0, 20, 20), true, PathRole::InnerWall, Deposit::Bead, {}};
  const std::vector<FillPath> pieces = clipped(run, {Region{rectangle(-1, -1, 10, 21), {}}});
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_FALSE(pieces[0].is_closed);
  EXPECT_NEAR(length(pieces[0].points), 40.0, 1e-9);
}

}  // namespace
}  // namespace lamina
