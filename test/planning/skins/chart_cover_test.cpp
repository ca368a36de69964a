// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What covers layers that need not be plane.
#include "planning/skins/chart_cover.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/geometry/mesh/box_mesh.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/parameterization/chart_outline.hpp"
#include "lamina/planning/lift/chart_lift.hpp"
#include "lamina/planning/planner.hpp"
#include "support/charts.hpp"

namespace lamina {
namespace {

constexpr double kSampledBead = 0.4;  // mm, width

/// Closed boxes, which may overlap.
Mesh bodiesOf(const std::vector<Box3>& boxes) {
  Mesh mesh;
  for (const Box3& box : boxes) {
    const Mesh body = boxMesh(box);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), body.vertices.begin(), body.vertices.end());
    for (const Triangle& corners : body.triangles)
      mesh.triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
  }
  return mesh;
}

Box3 boxFrom(const Point3& low, const Point3& high) {
  Box3 box;
  box.low = low;
  box.high = high;
  return box;
}

LayerCover coverIn(const Mesh& part, const LayerChart& chart, std::size_t above, std::size_t below) {
  const PartSpace space(part);
  return coverOnCharts({chart}, unite(outlineOf(chart)), space, {above, below, kSampledBead, 0.0});
}

/// Tops at 0.1 mm, where x is below 4 mm, and at 5 mm: beside the limb the layer is seen.
TEST(ChartCover, EndsAtTheFootOfAHigherLimb) {
  const Mesh part = bodiesOf({boxFrom({-1, -1, -5}, {11, 11, 0.1}), boxFrom({4, -1, -4}, {11, 11, 5})});
  const LayerCover cover = coverIn(part, test::levelChart(10, 5), 4, 4);
  EXPECT_NEAR(area(*cover.material), 100.0, 1e-3);
  EXPECT_NEAR(area(*cover.above), 60.0, 10 * 0.5 * kSampledBead);
  EXPECT_NEAR(area(*cover.whole), 60.0, 10 * 0.5 * kSampledBead);
  EXPECT_EQ(cover.below, cover.material) << "5 mm below are filled";
  for (const Region& covered : *cover.above)
    for (const Point2& corner : covered.outer) EXPECT_GE(corner.x(), 4.0 - 0.5 * kSampledBead - 1e-3);
}

/// From 0.3 to 0.5 mm above it there is a void: the second layer on is missing, the first and third are not.
TEST(ChartCover, FindsAVoidOfOneLayer) {
  const Mesh part = bodiesOf({boxFrom({-1, -1, -5}, {11, 11, 0.3}), boxFrom({-1, -1, 0.5}, {11, 11, 5})});
  const LayerChart chart = test::levelChart(10, 5);
  EXPECT_TRUE(coverIn(part, chart, 1, 4).isCovered());
  const LayerCover cover = coverIn(part, chart, 2, 4);
  EXPECT_EQ(cover.above, cover.material) << "the next layer is there";
  EXPECT_LT(area(*cover.whole), 1e-2);
  EXPECT_TRUE(coverIn(part, chart, 0, 4).isCovered()) << "no skin is asked for above";
}

/// A half cylinder of 5 mm that grows outwards in a block up to z = 5.5: of four layers on it, up to a radius
/// of 5.8 mm, one leaves the block where 5.8 sin(a) > 5.5.
TEST(ChartCover, LooksAlongTheGrowthOfBentLayers) {
  const double length = 12.0;
  const LayerChart chart = test::halfCylinder(5.0, length, 96);
  const Mesh block = bodiesOf({boxFrom({-20, -1, -20}, {20, 13, 5.5})});
  const LayerCover cover = coverIn(block, chart, 4, 4);
  const double seen_mm = 5.0 * (M_PI - 2.0 * std::asin(5.5 / 5.8));  // 3.23 mm along the arc
  EXPECT_NEAR(area(*cover.material) - area(*cover.whole), seen_mm * length, length * kSampledBead);
  EXPECT_EQ(cover.above, cover.material) << "5.2 mm lie within the block";
  EXPECT_EQ(cover.below, cover.material);
  EXPECT_TRUE(coverIn(bodiesOf({boxFrom({-20, -1, -20}, {20, 13, 20})}), chart, 4, 4).isCovered());
}

/// Nothing is looked up where walls lie: with walls as thick as the layer is wide, nothing at all.
TEST(ChartCover, LeavesOutWhatLiesUnderWalls) {
  const Mesh part = bodiesOf({boxFrom({-1, -1, -5}, {11, 11, 0.1})});
  const PartSpace space(part);
  const LayerChart chart = test::levelChart(10, 5);
  const Regions material = unite(outlineOf(chart));
  const LayerCover cover = coverOnCharts({chart}, material, space, {4, 4, kSampledBead, 2.0});
  EXPECT_GE(area(*cover.above), 100.0 - std::pow(10.0 - 2.0 * (2.0 - kSampledBead), 2));
  EXPECT_LE(area(*cover.above), 100.0 - std::pow(10.0 - 2.0 * 2.0, 2));
  EXPECT_TRUE(coverOnCharts({chart}, material, space, {4, 4, kSampledBead, 6.0}).isCovered());
}

/// Half of the layer is seen: beads of its skin hold what a solid fill would, and lie beyond the border by no
/// more than the anchor and half a bead.
TEST(ChartCover, DividesLiftedLayers) {
  const LayerChart chart = test::levelChart(10, 5);
  const Mesh part = bodiesOf({boxFrom({-1, -1, -5}, {11, 11, 0.1}), boxFrom({5, -1, -4}, {11, 11, 5})});
  PlanSettings settings;
  settings.skins.top_layers = settings.skins.bottom_layers = 4;
  settings.skins.anchor_mm = 0.0;
  settings.ironing.is_used = true;
  const std::vector<std::vector<LayerChart>> charts = {{chart}};
  const std::vector<Layer> layers = {{{-0.1, 0.1}, {outlineOf(chart), {}}}};
  LayerLifting lifting{chartLift(charts, {0.1}, {}, settings.travel)};
  lifting.covers = {coverIn(part, chart, 4, 4)};
  NoProgress nobody;
  double skin_mm3 = 0.0;
  for (const ToolpathLayer& layer : planPart("half", layers, settings, lifting, nobody).toolpath.layers)
    for (const Path& path : layer.paths) {
      EXPECT_NE(path.role, PathRole::Ironing) << "none on layers that are lifted";
      if (path.role != PathRole::TopSkin) continue;
      skin_mm3 += depositedVolume(path);
      for (const Point3& point : path.points) EXPECT_LE(point.x(), 5.0 + kSampledBead);
    }
  const double wall_mm = 0.2 + 1.5 * (0.4 - (1.0 - 0.25 * M_PI) * 0.2);  // two walls at their pitch
  const double expected_mm3 = 0.2 * (10.0 - 2.0 * wall_mm) * (5.0 - wall_mm);
  EXPECT_NEAR(skin_mm3, expected_mm3, 0.08 * expected_mm3);
}

}  // namespace
}  // namespace lamina
