// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/fit/hopeless_layers.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

#include "counted_checks.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kAboveMm = 60.0;
constexpr double kWallMm = 45.0;
constexpr double kLowMm = 5.0;

/// A machine without a tool axis to raise, whose head, 40 mm wide, is 25 mm above the tip.
struct UprightHead {
  SliceJob job;
  BuildSpace space = buildSpaceOf(job.settings.machine);
  PlanningRequest request{job, space, Eigen::Isometry3d(Eigen::Translation3d(110, 110, 0))};
  LeadTravels lead = [](Toolpath&) { return TravelsOverPart(); };
  test::CountedChecks progress;
  PlanCheck check{request, lead, progress, PlanLimits::AsRun};

  void leaveOutAtMost(double low_beads, const Toolpath& stack);

  std::optional<HopelessLayers> hopeless(const Toolpath& planned) const {
    const auto beyondReach = [](const MachineCheck& found) {
      std::vector<Finding> faults;
      std::copy_if(found.faults.begin(), found.faults.end(), std::back_inserter(faults),
                   [](const Finding& fault) { return fault.what != toString(JointFault::Singular); });
      return faults;
    };
    return hopelessLayers(planned, {check.model(), request.bed_from_part, job.settings}, check, beyondReach);
  }
};

ToolpathLayer layerOf(const Point3& from, const Point3& to) {
  Path travel = test::straightPath({from.x(), from.y(), kAboveMm}, from);
  travel.role = PathRole::Travel;
  travel.bead = Bead{};
  Path bead = test::straightPath(from, to);
  bead.bead = Bead{1.0, kLowMm};
  return {to.z(), to.z(), {travel, bead}};
}

/// A high wall, then 24 low beads of 40 mm, one a layer; the last of these lead to within 5 mm of the wall.
Toolpath wallAndLowBeads(std::size_t beside_the_wall) {
  constexpr std::size_t kLow = 24;
  Toolpath toolpath;
  toolpath.layers.push_back(layerOf({45, -45, kWallMm}, {45, 45, kWallMm}));
  for (std::size_t i = 0; i < kLow; ++i) {
    const double x = i < kLow - beside_the_wall ? -60.0 : 0.0;
    const double y = -24.0 + 2.0 * static_cast<double>(i);
    toolpath.layers.push_back(layerOf({x, y, kLowMm}, {x + 40.0, y, kLowMm}));
  }
  return toolpath;
}

double lowBeadVolume(const Toolpath& stack) { return depositedVolume(stack.layers.back().paths.back()); }

void UprightHead::leaveOutAtMost(double low_beads, const Toolpath& stack) {
  job.settings.volumetric.largest_left_out_percent =
      100.0 * low_beads * lowBeadVolume(stack) / totals(stack).deposited_mm3;
}

// 25 layers, every fifth of which is tried: the wall and four low beads, all of which lead there.
TEST(HopelessLayers, FewLayersAreEnoughWhereNoneCanBeMended) {
  const UprightHead plan;
  const Toolpath stack = wallAndLowBeads(24);
  const std::optional<HopelessLayers> found = plan.hopeless(stack);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(plan.progress.checks(), 2U) << "as planned, and as raised, though no tool axis leans";
  EXPECT_EQ(found->layers, 5U);
  EXPECT_NEAR(found->hindered_mm3, 4.0 * lowBeadVolume(stack), 1e-6);
  EXPECT_NEAR(found->most_mm3, 0.005 * totals(stack).deposited_mm3, 1e-9);
  ASSERT_FALSE(found->check.collisions.empty());
  EXPECT_EQ(found->check.collisions.front().at.layer, 5U);
}

TEST(HopelessLayers, TriesNoFurtherLayersWhereMostAreClear) {
  const UprightHead plan;
  EXPECT_FALSE(plan.hopeless(wallAndLowBeads(0)).has_value());
  EXPECT_EQ(plan.progress.checks(), 1U);
}

// Of layers 0, 5, 10, 15 and 20 one is hindered, 20: more than its share of what may be left out, but not
// more than may be left out. The next ones are 19, 21, 17, 23, 14 and 12, none of them side by side.
TEST(HopelessLayers, TriesTheLayersNearTheHinderedOnesWhereThoseBeforeDoNotDecide) {
  UprightHead plan;
  const Toolpath stack = wallAndLowBeads(5);
  plan.leaveOutAtMost(1.5, stack);
  const std::optional<HopelessLayers> found = plan.hopeless(stack);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(plan.progress.checks(), 4U);
  EXPECT_EQ(found->layers, 11U);
  EXPECT_NEAR(found->hindered_mm3, 3.0 * lowBeadVolume(stack), 1e-6);
  EXPECT_TRUE(std::is_sorted(found->check.collisions.begin(), found->check.collisions.end(),
                             [](const Finding& a, const Finding& b) { return a.at.layer < b.at.layer; }));
  EXPECT_EQ(found->check.collisions.front().at.layer, 20U);
}

// 22 and 24 are the next but these.
TEST(HopelessLayers, TriesOnWhereFurtherLayersAreHindered) {
  UprightHead plan;
  const Toolpath stack = wallAndLowBeads(5);
  plan.leaveOutAtMost(4.1, stack);
  const std::optional<HopelessLayers> found = plan.hopeless(stack);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(plan.progress.checks(), 6U);
  EXPECT_NEAR(found->hindered_mm3, 5.0 * lowBeadVolume(stack), 1e-6);
}

TEST(HopelessLayers, HaveHopeWhereNoneNearTheHinderedOnesIs) {
  UprightHead plan;
  Toolpath stack = wallAndLowBeads(0);
  stack.layers[20] = wallAndLowBeads(5).layers[20];
  plan.leaveOutAtMost(1.5, stack);
  EXPECT_FALSE(plan.hopeless(stack).has_value());
  EXPECT_EQ(plan.progress.checks(), 3U) << "the next layers are clear as planned";
}

TEST(HopelessLayers, HaveHopeWhereSoMuchMayBeLeftOut) {
  UprightHead plan;
  plan.job.settings.volumetric.largest_left_out_percent = 100.0;
  EXPECT_FALSE(plan.hopeless(wallAndLowBeads(24)).has_value());
  EXPECT_EQ(plan.progress.checks(), 2U);
}

// One bead ends 1000 mm beside the bed: raising is not tried, however much may be left out.
TEST(HopelessLayers, OneBeadOutOfReachIsEnough) {
  UprightHead plan;
  plan.job.settings.volumetric.largest_left_out_percent = 100.0;
  Toolpath stack = wallAndLowBeads(0);
  stack.layers[10].paths.back().points.back().x() = 1000.0;
  const std::optional<HopelessLayers> found = plan.hopeless(stack);
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->is_out_of_reach);
  EXPECT_EQ(plan.progress.checks(), 1U);
  EXPECT_EQ(found->layers, 5U);
  ASSERT_FALSE(found->check.faults.empty());
  EXPECT_EQ(found->check.faults.front().at.layer, 10U);
  EXPECT_TRUE(found->check.collisions.empty());
}

// A singular place takes no room: the nozzle turns off the bead there.
TEST(HopelessLayers, CountBeadsAloneAndNoSingularPlaces) {
  const Toolpath stack = wallAndLowBeads(0);
  const double bead_mm3 = lowBeadVolume(stack);
  MachineCheck check;
  check.waypoints = 4;
  check.faults.push_back({{24, 1, 0}, Point3::Zero(), toString(JointFault::Singular), "turns", 0, ""});
  check.collisions.push_back({{23, 0, 1}, Point3::Zero(), "collision", "on a travel", 0, ""});
  EXPECT_EQ(hinderedVolume(check, stack), 0.0);
  check.faults.push_back({{22, 1, 0}, Point3::Zero(), toString(JointFault::OutOfLimits), "beyond", 0, ""});
  EXPECT_NEAR(hinderedVolume(check, stack), bead_mm3, 1e-6);
  check.collisions.push_back({{21, 1, 1}, Point3::Zero(), "collision", "on a bead", 0, ""});
  EXPECT_NEAR(hinderedVolume(check, stack), 2.0 * bead_mm3, 1e-6);
}

}  // namespace
}  // namespace lamina
