// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/layer_fill.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/geometry/polygon/polygon.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

constexpr double kFilledSide = 10.0;  // mm

Regions squareToFill() { return {{test::rectangle(0, 0, kFilledSide, kFilledSide), {}}}; }

PlanContext planFilledTo(double density) {
  PlanContext plan;
  plan.settings.bead.width_mm = 0.4;
  plan.settings.infill.density = density;
  plan.settings.infill.angle_deg = 0.0;
  plan.strategy = infillStrategy("zigzag");
  plan.skin_strategy = infillStrategy("zigzag");
  plan.layer_count = 10;
  return plan;
}

double filledArea(const std::vector<FillPath>& runs, double pitch_mm) {
  double sum = 0.0;
  for (const FillPath& run : runs)
    for (std::size_t i = 1; i < run.points.size(); ++i)
      sum += (run.width_mm.empty() ? pitch_mm : run.width_mm[i]) * (run.points[i] - run.points[i - 1]).norm();
  return sum;
}

TEST(LayerFill, OfSparseLinesRunsIntoTheWalls) {
  PlanContext plan = planFilledTo(0.2);
  plan.settings.infill.wall_overlap = 0.25;
  const LayerFill fill(plan, 5, test::kLayerHeight);
  EXPECT_FALSE(fill.isSolid());
  EXPECT_EQ(fill.contact(), WallContact::Overlapping);
  EXPECT_NEAR(fill.overlap(), 0.25 * 0.4, 1e-12);
  EXPECT_NEAR(fill.request().spacing_mm, test::kLayerPitch / 0.2, 1e-9);
}

TEST(LayerFill, OfSolidLinesIsFittedBetweenTheWalls) {
  PlanContext plan = planFilledTo(1.0);
  EXPECT_EQ(LayerFill(plan, 5, test::kLayerHeight).contact(), WallContact::Fitted);
  EXPECT_EQ(LayerFill(plan, 5, test::kLayerHeight).overlap(), 0.0);
  plan.settings.infill.bead_width_mm = 0.6;  // does not go on from walls of 0.4 mm
  const LayerFill wide(plan, 5, test::kLayerHeight);
  EXPECT_TRUE(wide.isFittedAlone());
  EXPECT_EQ(wide.contact(), WallContact::Beside);
}

TEST(LayerFill, IsSolidInOuterLayersOnly) {
  PlanContext plan = planFilledTo(0.0);
  plan.settings.infill.outer_layers = 2;
  for (std::size_t layer = 0; layer < plan.layer_count; ++layer) {
    const LayerFill fill(plan, layer, test::kLayerHeight);
    EXPECT_EQ(fill.isSolid(), layer < 2 || layer >= 8) << layer;
    EXPECT_EQ(fill.isNone(), layer >= 2 && layer < 8) << layer;
  }
}

TEST(LayerFill, WithoutWallsKeepsTheOutlineWhateverThePitch) {
  PlanContext plan = planFilledTo(1.0);
  plan.settings.infill.pitch_mm = 0.42;  // strips of 0.42 mm, of which the beads cover the pitch
  const double grown = kFilledSide + 0.42 - test::kLayerPitch;
  EXPECT_NEAR(area(LayerFill(plan, 5, test::kLayerHeight).area(squareToFill())), kFilledSide * kFilledSide,
              1e-6);
  plan.settings.walls.count = 0;
  EXPECT_NEAR(area(LayerFill(plan, 5, test::kLayerHeight).area(squareToFill())), grown * grown, 0.01);
}

TEST(LayerFill, FillsASquareFromBorderToBorderOnce) {
  const PlanContext plan = planFilledTo(1.0);
  const LayerFill fill(plan, 5, test::kLayerHeight);
  const SolidRuns runs = fill.solid(squareToFill(), PathRole::Skin, fill.request(), plan.strategy);
  EXPECT_TRUE(runs.in_turn.empty());
  ASSERT_FALSE(runs.any_order.empty());
  for (const FillPath& run : runs.any_order) EXPECT_EQ(run.role, PathRole::Skin);
  EXPECT_NEAR(filledArea(runs.any_order, fill.pitch()), kFilledSide * kFilledSide,
              0.02 * kFilledSide * kFilledSide);
  EXPECT_TRUE(fill.solid({}, PathRole::Skin, fill.request(), plan.strategy).any_order.empty());
}

TEST(LayerFill, LaysTopSkinsInTheSequenceInWhichTheyAreMade) {
  PlanContext plan = planFilledTo(0.2);
  const LayerFill fill(plan, 5, test::kLayerHeight);
  const InfillRequest request = fill.skinRequest(fill.request(), 90.0);
  EXPECT_NEAR(request.angle_rad, (45.0 + 90.0) * M_PI / 180.0, 1e-12);
  EXPECT_NEAR(request.spacing_mm, test::kLayerPitch, 1e-9);
  const SolidRuns top = fill.solid(squareToFill(), PathRole::TopSkin, request, plan.skin_strategy);
  EXPECT_FALSE(top.in_turn.empty());
  const SolidRuns bottom = fill.solid(squareToFill(), PathRole::BottomSkin, request, plan.skin_strategy);
  EXPECT_TRUE(bottom.in_turn.empty());
  plan.settings.skins.is_monotonic = false;
  EXPECT_TRUE(fill.solid(squareToFill(), PathRole::TopSkin, request, plan.skin_strategy).in_turn.empty());
}

}  // namespace
}  // namespace lamina
