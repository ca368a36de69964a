// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What holds a part to the bed, and fills the nozzle before it.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "lamina/base/error.hpp"
#include "planning/adhesion/brim.hpp"
#include "planning/adhesion/foot_brim.hpp"
#include "planning/adhesion/prime_line.hpp"
#include "planning/planned_aids.hpp"
#include "planning/skirt.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::kLayerHeight;
using test::kLayerPitch;
using test::rectangle;

const Box2 kWideBed{{-100, -100}, {100, 100}};

std::vector<Layer> cubeLayers() {
  return test::layersOf(10, [](int) { return std::vector<Polygon>{rectangle(-10, -10, 10, 10)}; });
}

/// Without skirt.
PlanSettings bare() {
  PlanSettings settings;
  settings.skirt.count = 0;
  return settings;
}

Plan plannedOn(const Box2& bed, const PlanSettings& settings,
               const std::vector<Layer>& layers = cubeLayers()) {
  NoProgress nobody;
  Plan plan = planPart("cube", layers, settings, bed, nobody);
  validate(plan.toolpath);
  return plan;
}

std::vector<Path> pathsOf(const ToolpathLayer& layer, PathRole role) {
  std::vector<Path> paths;
  for (const Path& path : layer.paths)
    if (path.role == role) paths.push_back(path);
  return paths;
}

double volumeBeside(const std::vector<Path>& paths) {
  double sum = 0.0;
  for (const Path& path : paths) sum += depositedVolume(path);
  return sum;
}

Box2 boxRound(const std::vector<Path>& paths) {
  Box2 box;
  for (const Path& path : paths)
    for (const Point3& point : path.points) box.include(point.head<2>());
  return box;
}

/// A cube of 20 mm in layers of 45 deg, by x and their own height; it covers 20 mm of the bed along either.
std::vector<Layer> inclinedCube(const Point2& by) {
  const double root = std::sqrt(0.5);
  std::vector<Layer> layers;
  for (int i = 0; i < 142; ++i) {
    Layer layer{{-5.0 / root + kLayerHeight * i, -5.0 / root + kLayerHeight * (i + 1)}, {}};
    const double n = layer.bounds.cut();
    const double low = std::max(-n, n - 10.0 / root);
    const double high = std::min(20.0 / root - n, n + 10.0 / root);
    if (high > low)
      layer.section.contours.push_back(rectangle(by.x() - 10.0, by.y() + low, by.x() + 10.0, by.y() + high));
    layers.push_back(layer);
  }
  return layers;
}

Plan inclinedOn(const PlanSettings& settings, const Point2& by) {
  const double root = std::sqrt(0.5);
  NoProgress nobody;
  return planPart("cube", inclinedCube(by), settings,
                  LayerIncline{{{0, root, root}, root * by.y()}, Eigen::Quaterniond::Identity()}, nobody);
}

std::vector<Path> brimOf(const Plan& plan) {
  std::vector<Path> brim;
  for (const ToolpathLayer& layer : plan.toolpath.layers)
    for (Path& path : pathsOf(layer, PathRole::Brim)) brim.push_back(std::move(path));
  return brim;
}

/// 5 mm round 20 mm are rows 0.2 / sin 45 deg apart, whose ends keep half a pitch off part and edge.
TEST(Brim, OfInclinedLayersLiesBesideTheirFeet) {
  PlanSettings settings = bare();
  settings.adhesion.brim.width_mm = 5.0;
  const double root = std::sqrt(0.5);
  const double row_mm = kLayerHeight / root;
  const double width_mm = 14 * kLayerPitch;
  const double length_mm = 2 * width_mm / row_mm * (20 + 2 * width_mm - kLayerPitch) +
                           20.0 / row_mm * 2 * (width_mm - kLayerPitch);
  for (const Point2& by : {Point2(0, 0), Point2(0, 12500)}) {
    const Plan plan = inclinedOn(settings, by);
    const std::vector<Path> brim = brimOf(plan);
    EXPECT_NEAR(volumeBeside(brim), length_mm * kLayerPitch * kLayerHeight,
                0.03 * length_mm * kLayerPitch * kLayerHeight);
    double before_mm = 0.0;
    double after_mm = 0.0;
    for (const Path& path : brim)
      for (const Point3& point : path.points) {
        const double cut = point.z() - 0.5 * kLayerHeight;
        EXPECT_NEAR(point.y() - by.y() + cut, 0.2, 1e-4) << "half a bead from the bed";
        const double along = cut / root;
        before_mm = std::max(before_mm, -10.0 - along);
        after_mm = std::max(after_mm, along - 10.0);
        EXPECT_TRUE(std::abs(along) > 10.0 || std::abs(point.x()) > 10.0) << point.transpose();
        EXPECT_LT(std::abs(point.x()), 15.0);
      }
    EXPECT_NEAR(before_mm, 5.0, row_mm);
    EXPECT_NEAR(after_mm, 5.0, 2 * row_mm);
  }
}

TEST(Brim, LeavesInclinedLayersAsTheyAreWithout) {
  PlanSettings settings = bare();
  const Plan without = inclinedOn(settings, Point2::Zero());
  settings.adhesion.brim.width_mm = 2.0;
  const Plan with = inclinedOn(settings, Point2::Zero());
  EXPECT_TRUE(brimOf(without).empty());
  EXPECT_GT(with.toolpath.layers.size(), without.toolpath.layers.size()) << "rows before the part";
  const auto part_mm3 = [](const Plan& plan) {
    double sum = 0.0;
    for (const ToolpathLayer& layer : plan.toolpath.layers)
      for (const Path& path : layer.paths)
        if (path.role != PathRole::Brim && path.role != PathRole::Travel) sum += depositedVolume(path);
    return sum;
  };
  EXPECT_NEAR(part_mm3(with) / part_mm3(without), 1.0, 1e-3);
}

/// At 15 deg the feet of layers of 0.2 mm are 0.773 mm apart, 2.16 pitches.
TEST(Brim, OfSlightlyInclinedLayersHasSeveralLinesEach) {
  const double angle = M_PI / 12.0;
  const BedPlane bed{{0, std::sin(angle), std::cos(angle)}, 0.0};
  Layer layer{{0.0, kLayerHeight}, {}};
  const double foot = -layer.bounds.cut() / std::tan(angle);
  layer.section.contours = {rectangle(-10, foot, 10, foot + 20)};
  BrimSettings settings;
  settings.width_mm = 5.0;
  const std::vector<FootBrim> brims = footBrim({layer}, bed, settings, 0.4);
  ASSERT_EQ(brims.front().runs.size(), 4U) << "two lines to each side";
  for (const FillPath& run : brims.front().runs) {
    const double from_foot = run.points.front().y() - foot;
    EXPECT_TRUE(std::abs(from_foot - 0.2) < 1e-6 || std::abs(from_foot - 0.2 - kLayerPitch) < 1e-6);
    EXPECT_NEAR(length(run.points), 13 * kLayerPitch, 1e-4);
  }
}

TEST(Brim, OfACubeIsFourteenLoopsOutermostFirst) {
  PlanSettings settings = bare();
  settings.adhesion.brim.width_mm = 5.0;
  const Plan plan = plannedOn(kWideBed, settings);
  const std::vector<Path> brim = pathsOf(plan.toolpath.layers.front(), PathRole::Brim);
  ASSERT_EQ(brim.size(), 14U);
  const double wanted = (30.0 * 30.0 - 20.0 * 20.0) * kLayerHeight;
  EXPECT_NEAR(volumeBeside(brim), wanted, 0.02 * wanted);
  for (std::size_t i = 0; i < brim.size(); ++i) {
    const double beyond = (13.5 - static_cast<double>(i)) * kLayerPitch;
    EXPECT_NEAR(boxRound({brim[i]}).high.x(), 10.0 + beyond, 1e-4) << i;
    EXPECT_TRUE(brim[i].is_closed);
  }
  EXPECT_TRUE(pathsOf(plan.toolpath.layers[1], PathRole::Brim).empty());
}

TEST(Brim, KeepsItsGap) {
  BrimSettings settings;
  settings.width_mm = 2.0;
  settings.gap_mm = 0.5;
  const Brim brim = makeBrim({{rectangle(0, 0, 10, 10), {}}}, settings, 0.4, {});
  ASSERT_EQ(brim.runs.size(), 5U);
  EXPECT_NEAR(perimeter(brim.runs.back().points), 40.0 + 8.0 * 0.7, 1e-3);
  EXPECT_NEAR(area(brim.area), std::pow(15.0, 2) - std::pow(11.0, 2), 1e-3);
}

TEST(Brim, LiesOutsideInsideOrBoth) {
  const Regions ring = {{rectangle(0, 0, 40, 40), {test::reversed(rectangle(10, 10, 30, 30))}}};
  const auto areaOf = [&](BrimWhere where) {
    BrimSettings settings;
    settings.width_mm = 2.0;
    settings.where = where;
    return area(makeBrim(ring, settings, 0.4, {}).area);
  };
  const double outside = std::pow(44.0, 2) - std::pow(40.0, 2);
  const double inside = std::pow(20.0, 2) - std::pow(16.0, 2);
  EXPECT_NEAR(areaOf(BrimWhere::Outside), outside, 1e-2);
  EXPECT_NEAR(areaOf(BrimWhere::Inside), inside, 1e-2);
  EXPECT_NEAR(areaOf(BrimWhere::Both), outside + inside, 1e-2);
}

TEST(Brim, OfNeighboursUnites) {
  BrimSettings settings;
  settings.width_mm = 4.0;
  const Brim brim =
      makeBrim({{rectangle(0, 0, 10, 10), {}}, {rectangle(12, 0, 22, 10), {}}}, settings, 0.4, {});
  // 10 x 10 mm twice, 2 mm apart: grown by 4 mm they are one of 30 x 18 mm.
  EXPECT_NEAR(area(brim.area), 30.0 * 18.0 - 200.0, 1e-2);
  EXPECT_NEAR(perimeter(brim.runs.front().points), 2 * (29.6 + 17.6), 1e-2);
}

TEST(Brim, OfEarsLiesAtSharpCornersOnly) {
  BrimSettings settings;
  settings.width_mm = 3.0;
  settings.ears = true;
  // Square, and an octagon whose corners are of 135 deg.
  const Brim square = makeBrim({{rectangle(0, 0, 20, 20), {}}}, settings, 0.5, {});
  // Six loops; of those at 2.25 and 2.75 mm the mitre lies beyond the ear, and leaves one piece on each side.
  ASSERT_EQ(square.runs.size(), 4U * (4U + 2U * 2U));
  for (const FillPath& run : square.runs) {
    EXPECT_FALSE(run.is_closed);
    for (const Point2& point : run.points) {
      double nearest = 100.0;
      for (const Point2& corner : rectangle(0, 0, 20, 20))
        nearest = std::min(nearest, (point - corner).norm());
      EXPECT_LE(nearest, 3.0 + 1e-9);
    }
  }
  EXPECT_TRUE(makeBrim({{test::circle({0, 0}, 10, 8), {}}}, settings, 0.5, {}).runs.empty());
}

TEST(Brim, EndsAtTheEdgeOfTheBed) {
  PlanSettings settings = bare();
  settings.adhesion.brim.width_mm = 5.0;
  const Plan plan = plannedOn({{-12, -100}, {100, 100}}, settings);
  const std::vector<Path> brim = pathsOf(plan.toolpath.layers.front(), PathRole::Brim);
  EXPECT_GE(boxRound(brim).low.x(), -12.0 - 1e-9);
  EXPECT_NEAR(boxRound(brim).high.x(), 15.0 - 0.5 * kLayerPitch, 0.01);
  const double cut = 3.0 * 30.0;  // of 5 mm, 3 lie beyond the bed
  EXPECT_NEAR(volumeBeside(brim), (500.0 - cut) * kLayerHeight, 0.03 * 410.0 * kLayerHeight);
}

TEST(Skirt, GoesRoundTheBrim) {
  PlanSettings settings;
  settings.adhesion.brim.width_mm = 5.0;
  const Plan plan = plannedOn(kWideBed, settings);
  const Box2 box = boxRound(pathsOf(plan.toolpath.layers.front(), PathRole::Skirt));
  EXPECT_NEAR(box.high.x(), 10.0 + 14 * kLayerPitch + settings.skirt.distance_mm + 0.2, 0.01);
}

TEST(Skirt, StandsAroundAsManyLayersAsAsked) {
  PlanSettings settings;
  settings.skirt.layers = 7;
  // The part leans by 1 mm a layer: the skirt keeps its distance from the farthest of them.
  const auto leaning =
      test::layersOf(10, [](int l) { return std::vector<Polygon>{rectangle(-10 + l, -10, 10 + l, 10)}; });
  const Plan plan = plannedOn(kWideBed, settings, leaning);
  for (std::size_t l = 0; l < 10; ++l) {
    const std::vector<Path> skirt = pathsOf(plan.toolpath.layers[l], PathRole::Skirt);
    EXPECT_EQ(skirt.size(), l < 7 ? 1U : 0U) << l;
    if (skirt.empty()) continue;
    EXPECT_NEAR(boxRound(skirt).high.x(), 16.0 + settings.skirt.distance_mm + 0.2, 1e-3);
  }
}

TEST(Skirt, IsAsLongAsAsked) {
  PlanSettings settings;
  settings.skirt.least_length_mm = 500.0;
  const std::vector<Polygon> loops = makeSkirt({{rectangle(-10, -10, 10, 10), {}}}, settings);
  double length_mm = 0.0;
  for (const Polygon& loop : loops) length_mm += perimeter(loop);
  EXPECT_GE(length_mm, 500.0);
  EXPECT_LT(length_mm - perimeter(loops.front()), 500.0) << "without the outermost it is too short";
  for (std::size_t i = 1; i < loops.size(); ++i) EXPECT_GT(perimeter(loops[i - 1]), perimeter(loops[i]));
}

TEST(Raft, LiesBelowThePartThatKeepsItsPlace) {
  PlanSettings settings = bare();
  settings.adhesion.raft.layers = 4;
  const Plan plan = plannedOn(kWideBed, settings);
  ASSERT_EQ(plan.toolpath.layers.size(), 14U);
  const double height = 0.3 + 3 * kLayerHeight;
  EXPECT_NEAR(plan.raft_mm, height + 0.15, 1e-9);
  EXPECT_NEAR(plan.toolpath.layers[0].z_mm, 0.3 - plan.raft_mm, 1e-9);
  EXPECT_NEAR(plan.toolpath.layers[3].z_mm, -0.15, 1e-9) << "a gap below the part";
  EXPECT_NEAR(plan.toolpath.layers[4].z_mm, kLayerHeight, 1e-9);
  const double square = 26.0 * 26.0;  // 3 mm wider all round
  for (std::size_t l = 0; l < 4; ++l) {
    const std::vector<Path> raft = pathsOf(plan.toolpath.layers[l], PathRole::Raft);
    const double density = l < 2 ? 0.5 : 1.0;
    // Lines end half a bead inside, and are joined.
    const double wanted = square * density * plan.toolpath.layers[l].height_mm;
    EXPECT_GT(volumeBeside(raft), 0.95 * wanted) << l;
    EXPECT_LT(volumeBeside(raft), 1.06 * wanted) << l;
    EXPECT_NEAR(boxRound(raft).high.x(), 13.0 - 0.5 * planWidth(raft.front().bead.at(1)), 0.75)
        << "the last line is at most a spacing inside";
  }
  EXPECT_EQ(toolpathId(plannedOn(kWideBed, bare()).toolpath), [&] {
    Toolpath above = plan.toolpath;
    above.layers.erase(above.layers.begin(), above.layers.begin() + 4);
    // The way up from the raft.
    auto& first = above.layers.front().paths;
    if (first.front().role == PathRole::Travel) first.erase(first.begin());
    return toolpathId(above);
  }()) << "the part is printed as without raft";
}

TEST(Raft, CarriesSupportsToo) {
  PlanSettings settings = bare();
  settings.adhesion.raft.layers = 2;
  settings.supports.use = true;
  const auto tee = test::layersOf(30, [](int l) {
    return std::vector<Polygon>{l < 20 ? rectangle(-3, -10, 3, 10) : rectangle(-20, -10, 20, 10)};
  });
  const Plan plan = plannedOn(kWideBed, settings, tee);
  EXPECT_GT(boxRound(pathsOf(plan.toolpath.layers[0], PathRole::Raft)).high.x(), 22.0);
  EXPECT_FALSE(pathsOf(plan.toolpath.layers[2], PathRole::Support).empty());
}

TEST(Raft, AndBrimAreRefusedTogether) {
  PlanSettings settings = bare();
  settings.adhesion.raft.layers = 2;
  settings.adhesion.brim.width_mm = 3.0;
  EXPECT_THROW(plannedOn(kWideBed, settings), InvalidConfig);
}

TEST(PrimeLine, ComesFirstAlongTheEdgeOfTheBed) {
  PlanSettings settings;
  settings.adhesion.prime.line = PrimeLine::Front;
  const Plan plan = plannedOn(kWideBed, settings);
  const Path& line = plan.toolpath.layers.front().paths.front();
  ASSERT_EQ(line.role, PathRole::Prime);
  EXPECT_NEAR(length(line), 100.0, 1e-9);
  EXPECT_NEAR(depositedVolume(line), 50.0, 1e-6) << "0.5 mm2 over 100 mm";
  EXPECT_NEAR(line.firstPoint().y(), -100.0 + line.bead.at(0).width_mm, 1e-9);
  settings.adhesion.prime.line = PrimeLine::Left;
  const Path left = plannedOn(kWideBed, settings).toolpath.layers.front().paths.front();
  EXPECT_NEAR(left.firstPoint().x(), left.lastPoint().x(), 1e-9);
  EXPECT_NEAR(left.firstPoint().x(), -100.0 + left.bead.at(0).width_mm, 1e-9);
}

TEST(PrimeLine, IsRefusedWhereItHasNoRoom) {
  PlanSettings settings;
  settings.adhesion.prime.line = PrimeLine::Front;
  EXPECT_THROW(plannedOn({{-40, -40}, {40, 40}}, settings), InvalidConfig) << "longer than the bed";
  EXPECT_THROW(plannedOn({{-60, -14}, {60, 40}}, settings), InvalidConfig) << "across the skirt";
}

TEST(PrimeLine, IsRefusedWithinWhatLiesBelowThePart) {
  PlanSettings settings;
  settings.adhesion.prime.line = PrimeLine::Front;
  settings.adhesion.prime.length_mm = 4.0;
  const Box2 within{{-4.0, -4.0}, {4.0, 4.0}};
  for (const int raft_layers : {0, 2})
    for (const int skirts : {0, 1}) {
      settings.adhesion.raft.layers = raft_layers;
      settings.skirt.count = skirts;
      EXPECT_THROW(plannedOn(within, settings), InvalidConfig) << raft_layers << ", " << skirts;
    }
}

TEST(SupportTotals, OfOtherLayersAreAdded) {
  const SupportTotals a{1.0, 2.0, 3.0, 40.0, 5.0, 6.0, 7};
  const SupportTotals b{10.0, 20.0, 30.0, 4.0, 50.0, 60.0, 70};
  const SupportTotals sum = sumOf(a, b);
  EXPECT_EQ(sum.overhang_mm2, 11.0);
  EXPECT_EQ(sum.unsupported_mm2, 22.0);
  EXPECT_EQ(sum.blocked_mm2, 33.0);
  EXPECT_EQ(sum.area_mm2, 40.0) << "of the layer with the most";
  EXPECT_EQ(sum.support_mm3, 55.0);
  EXPECT_EQ(sum.interface_mm3, 66.0);
  EXPECT_EQ(sum.dropped_branches, 77U);
}

/// Their areas are those of the whole stack, and layers of a stretch are moved.
TEST(PlannedAids, OfLayersFarOutHaveNoRegions) {
  std::vector<Layer> layers = cubeLayers();
  for (Layer& layer : layers)
    for (Polygon& contour : layer.section.contours)
      for (Point2& point : contour) point.y() += 12000.0;
  PlanContext context;
  context.settings.supports.use = true;
  const double root = std::sqrt(0.5);
  context.bed = BedPlane{{0.0, root, root}, root * 12000.0};
  NoProgress nobody;
  const std::vector<PlanVariant> none;
  EXPECT_NO_THROW(planAids(layers, context, {&none, nullptr}, nobody));
  SupportMarks marks;
  marks.never.resize(layers.size());
  EXPECT_THROW(planAids(layers, context, {nullptr, &marks}, nobody), InvalidInput);
  const std::vector<PlanVariant> one = {{context.settings, std::vector<Regions>(layers.size())}};
  EXPECT_THROW(planAids(layers, context, {&one, nullptr}, nobody), InvalidInput);
}

}  // namespace
}  // namespace lamina
