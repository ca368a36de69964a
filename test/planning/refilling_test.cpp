// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/planning/planner.hpp"
#include "lamina/voids/beads/refill.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;

constexpr double kRefillingHeight = 0.2;

/// A plate with a round hole, which squares of a Hilbert curve fill badly.
const Regions kPlate = {{rectangle(0, 0, 12, 12), {test::reversed(circle({6, 6}, 3, 60))}}};

PlanSettings hilbert(VoidRefill refill) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.walls.count = 1;
  settings.infill.strategy = "hilbert";
  settings.infill.density = 1.0;
  settings.voids.refill = refill;
  return settings;
}

Plan refillingPlanned(const PlanSettings& settings) {
  const std::vector<Layer> layers = {{{0.0, kRefillingHeight}, {outlines(kPlate), {}}}};
  NoProgress progress;
  return planPart("plate", layers, settings, progress);
}

LayerVoids voidsOf(const Plan& plan) { return findVoids(kPlate, plan.toolpath.layers.front(), {}); }

TEST(Refilling, IsNotDoneByDefault) {
  const Plan plan = refillingPlanned(hilbert(PlanSettings().voids.refill));
  EXPECT_EQ(plan.refilling.runs, 0U);
  EXPECT_EQ(plan.refilling.deposited_mm3, 0.0);
}

TEST(Refilling, LeavesNoVoidThatABeadCanFill) {
  const PlanSettings settings = hilbert(VoidRefill::Beads);
  RefillSettings fillable;
  fillable.least_area = settings.voids.least_area;
  const LayerVoids before = voidsOf(refillingPlanned(hilbert(VoidRefill::None)));
  ASSERT_GT(refill(before, fillable).size(), 3U);
  const LayerVoids after = voidsOf(refillingPlanned(settings));
  EXPECT_TRUE(refill(after, fillable).empty());
  EXPECT_LT(after.uncovered_mm2, before.uncovered_mm2);
}

TEST(Refilling, FillsNoMoreForALesserFlow) {
  const Plan usual = refillingPlanned(hilbert(VoidRefill::Beads));
  PlanSettings less = hilbert(VoidRefill::Beads);
  less.bead.flow = 0.8;
  const Plan plan = refillingPlanned(less);
  EXPECT_EQ(plan.refilling.runs, usual.refilling.runs);
  EXPECT_NEAR(plan.refilling.deposited_mm3, 0.8 * usual.refilling.deposited_mm3,
              1e-6 * usual.refilling.deposited_mm3);
}

TEST(Refilling, CountsWhatItAdds) {
  const Plan without = refillingPlanned(hilbert(VoidRefill::None));
  const Plan with = refillingPlanned(hilbert(VoidRefill::Beads));
  EXPECT_EQ(voidsOf(with).runs, voidsOf(without).runs + with.refilling.runs);
  EXPECT_NEAR(totals(with.toolpath).deposited_mm3,
              totals(without.toolpath).deposited_mm3 + with.refilling.deposited_mm3, 1e-9);
}

TEST(Refilling, LeavesASparseInfillAndAHollowPartAsTheyAre) {
  for (const double density : {0.0, 0.2}) {
    PlanSettings settings = hilbert(VoidRefill::Beads);
    settings.walls.count = 2;
    settings.infill.density = density;
    EXPECT_EQ(refillingPlanned(settings).refilling.runs, 0U) << density;
  }
}

}  // namespace
}  // namespace lamina
