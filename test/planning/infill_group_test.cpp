// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Infill that several layers share.
#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

std::vector<Layer> block(int layers) {
  return test::layersOf(layers, [](int) { return std::vector<Polygon>{rectangle(0, 0, 40, 40)}; });
}

PlanSettings sharedInfill(int every_layers) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.bead.width_mm = 0.8;
  settings.infill.density = 0.2;
  settings.infill.links.link = LineLink::None;
  settings.infill.every_layers = every_layers;
  return settings;
}

double sparseVolume(const std::vector<ToolpathLayer>& layers) {
  double sum = 0.0;
  for (const ToolpathLayer& layer : layers)
    for (const Path& path : layer.paths)
      if (path.role == PathRole::Infill) sum += depositedVolume(path);
  return sum;
}

bool hasInfill(const ToolpathLayer& layer) { return sparseVolume({layer}) > 0.0; }

/// Direction of the longest motion of infill, within [0, 180) deg.
double lineDirection(const ToolpathLayer& layer) {
  double longest = 0.0;
  double angle_deg = 0.0;
  for (const Path& path : layer.paths)
    for (std::size_t m = 0; path.role == PathRole::Infill && m < path.motionCount(); ++m) {
      const Point3 way = path.points[path.motionEnd(m)] - path.points[m];
      if (way.norm() <= longest) continue;
      longest = way.norm();
      angle_deg = std::fmod(std::atan2(way.y(), way.x()) * 180.0 / M_PI + 360.0, 180.0);
    }
  return angle_deg;
}

TEST(InfillGroup, IsDepositedInItsLastLayerAsHighAsAllOfThem) {
  const Toolpath plan = test::plan(block(12), sharedInfill(3));
  for (std::size_t l = 0; l < 12; ++l) {
    EXPECT_EQ(hasInfill(plan.layers[l]), l % 3 == 2) << l;
    for (const Path& path : plan.layers[l].paths)
      if (path.role == PathRole::Infill) {
        EXPECT_NEAR(path.bead.at(0).height_mm, 0.6, 1e-9);
      }
  }
}

/// Lines at p / density apart hold density times the height of the group on each place, whatever its height.
TEST(InfillGroup, HoldsAsMuchAsTheLayersOnTheirOwn) {
  const double apart = sparseVolume(test::plan(block(12), sharedInfill(1)).layers);
  for (const int every_layers : {2, 3}) {
    const double together = sparseVolume(test::plan(block(12), sharedInfill(every_layers)).layers);
    EXPECT_NEAR(together, apart, 0.03 * apart) << every_layers;
  }
}

TEST(InfillGroup, TurnsFromGroupToGroup) {
  const Toolpath plan = test::plan(block(8), sharedInfill(2));
  EXPECT_NEAR(lineDirection(plan.layers[1]), 45.0, 1e-6);
  EXPECT_NEAR(lineDirection(plan.layers[3]), 135.0, 1e-6);
  EXPECT_NEAR(lineDirection(plan.layers[5]), 45.0, 1e-6);
}

TEST(InfillGroup, EndsWithThePartWhereItIsNotComplete) {
  const Toolpath plan = test::plan(block(5), sharedInfill(3));
  EXPECT_TRUE(hasInfill(plan.layers[2]));
  EXPECT_FALSE(hasInfill(plan.layers[3]));
  EXPECT_TRUE(hasInfill(plan.layers[4]));
  EXPECT_NEAR(sparseVolume({plan.layers[4]}) / sparseVolume({plan.layers[2]}), 2.0 / 3.0, 0.03);
}

TEST(InfillGroup, LeavesToEachLayerWhatIsSparseInSomeOfThemOnly) {
  // A step in the middle of a group: beyond it the lower layer is alone.
  const auto layers =
      test::layersOf(4, [](int i) { return std::vector<Polygon>{rectangle(0, 0, i < 3 ? 40 : 20, 40)}; });
  const Toolpath plan = test::plan(layers, sharedInfill(2));
  double alone_from = 40.0;
  ASSERT_TRUE(hasInfill(plan.layers[2]));
  for (const Path& path : plan.layers[2].paths)
    for (const Point3& point : path.points)
      if (path.role == PathRole::Infill) alone_from = std::min(alone_from, point.x());
  EXPECT_GT(alone_from, 17.0);
  for (const Path& path : plan.layers[2].paths)
    if (path.role == PathRole::Infill) {
      EXPECT_NEAR(path.bead.at(0).height_mm, 0.2, 1e-9);
    }
}

TEST(InfillGroup, LeavesSkinsAndSolidLayersAlone) {
  PlanSettings settings = sharedInfill(2);
  settings.skins.top_layers = settings.skins.bottom_layers = 3;
  const Toolpath plan = test::plan(block(12), settings);
  for (const std::size_t l : {0U, 1U, 2U, 9U, 10U, 11U}) EXPECT_FALSE(hasInfill(plan.layers[l])) << l;
  EXPECT_TRUE(hasInfill(plan.layers[3])) << "alone: the layer below in its group is skin";
  EXPECT_TRUE(hasInfill(plan.layers[5]));
  EXPECT_FALSE(hasInfill(plan.layers[4]));
  EXPECT_TRUE(hasInfill(plan.layers[8])) << "alone";
  PlanSettings outer = sharedInfill(2);
  outer.infill.outer_layers = 1;
  const Toolpath closed = test::plan(block(4), outer);
  const double solid = sparseVolume({closed.layers[0]});
  EXPECT_NEAR(solid, sparseVolume({closed.layers[3]}), 0.02 * solid);
  EXPECT_TRUE(hasInfill(closed.layers[1])) << "alone beside a solid one";
}

TEST(InfillGroup, IsOfLevelLayersPlannedByThemselves) {
  PlanSettings settings = sharedInfill(2);
  settings.infill.strategy = "contour";
  EXPECT_THROW(test::plan(block(2), settings), InvalidConfig);
}

/// In inclined layers so far along the belt; the bed lies far below.
Toolpath farAlong(std::vector<Layer> layers, PlanSettings settings, double out_mm) {
  settings.anchoring.strategy = Anchoring::None;
  for (Layer& layer : layers)
    for (Polygon& contour : layer.section.contours)
      for (Point2& point : contour) point.y() += out_mm;
  const double angle = M_PI / 9.0;
  const Point3 up(0.0, std::sin(angle), std::cos(angle));
  NoProgress nobody;
  Plan plan =
      planPart("part", layers, settings, LayerIncline{{up, out_mm * std::sin(angle) - 50.0}, {}}, nobody);
  validate(plan.toolpath);
  return plan.toolpath;
}

TEST(InfillGroup, IsTheSameFarAlongABelt) {
  const double near = sparseVolume(farAlong(block(12), sharedInfill(3), 0.0).layers);
  EXPECT_GT(near, 0.0);
  for (const double out_mm : {12500.0, 31000.0}) {
    const Toolpath plan = farAlong(block(12), sharedInfill(3), out_mm);
    for (std::size_t l = 0; l < 12; ++l) EXPECT_EQ(hasInfill(plan.layers[l]), l % 3 == 2) << l;
    EXPECT_NEAR(sparseVolume(plan.layers), near, 0.02 * near) << out_mm;
  }
}

TEST(Lightning, HoldsUpSkinsFarAlongABelt) {
  PlanSettings settings = sharedInfill(1);
  settings.infill.strategy = "lightning";
  settings.skins.top_layers = settings.skins.bottom_layers = 2;
  const double near = sparseVolume(farAlong(block(30), settings, 0.0).layers);
  EXPECT_GT(near, 0.0);
  for (const double out_mm : {12500.0, 31000.0}) {
    const double far = sparseVolume(farAlong(block(30), settings, out_mm).layers);
    // Places that are to be held lie on a grid, at other phases out there.
    EXPECT_NEAR(far, near, 0.1 * near) << out_mm;
  }
}

}  // namespace
}  // namespace lamina
