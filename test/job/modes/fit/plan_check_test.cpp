// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/fit/plan_check.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "job/modes/fit/machine_fit.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/base/random.hpp"
#include "lamina/kinematics/model/build_space.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kClearMm = 60.0;  // above all that is deposited

/// A job for a machine whose joints are no choice, and whose head, 40 mm wide, is 25 mm above the tip.
struct GantryPlan {
  SliceJob job;
  BuildSpace space = buildSpaceOf(job.settings.machine);
  PlanningRequest request{job, space, Eigen::Isometry3d(Eigen::Translation3d(110, 110, 0))};
  LeadTravels lead = [](Toolpath&) { return TravelsOverPart(); };
  NoProgress nobody;
  PlanCheck check{request, lead, nobody};
};

Path travelTo(const Point3& from, const Point3& to) {
  Path travel = test::straightPath(from, to);
  travel.role = PathRole::Travel;
  travel.bead = Bead{};
  travel.points = {from, {from.x(), from.y(), kClearMm}, {to.x(), to.y(), kClearMm}, to};
  return travel;
}

/// Beads of 1 mm that reach down to the bed, one a layer, with travels to them.
Toolpath beadsBetween(const std::vector<std::pair<Point3, Point3>>& ends) {
  Toolpath toolpath;
  Point3 last(0, 0, kClearMm);
  for (const auto& [from, to] : ends) {
    Path bead = test::straightPath(from, to);
    bead.bead = Bead{1.0, to.z()};
    toolpath.layers.push_back({to.z(), to.z(), {travelTo(last, from), bead}});
    last = to;
  }
  return toolpath;
}

using Found = std::set<std::pair<WaypointIndex, std::string>>;

Found foundIn(const MachineCheck& check, const std::set<std::size_t>& layers) {
  Found found;
  for (const Finding& finding : check.collisions)
    if (layers.count(finding.at.layer) != 0) found.insert({finding.at, finding.reason});
  return found;
}

std::set<WaypointIndex> placesOf(const MachineCheck& check) {
  std::set<WaypointIndex> places;
  for (const Finding& finding : check.collisions) places.insert(finding.at);
  return places;
}

TEST(PlanCheck, FindsInChangedLayersWhatTheWholeCheckFinds) {
  EXPECT_TRUE(rc::check("beads of any height, some of them shortened", [](std::uint64_t seed) {
    Random random(seed);
    std::vector<std::pair<Point3, Point3>> ends;
    const auto place = [&](double z) {
      return Point3(random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0), z);
    };
    for (int i = 0; i < 14; ++i) {
      const double z = random.uniform(0.0, 1.0) < 0.5 ? 5.0 : 45.0;
      ends.emplace_back(place(z), place(z));
    }
    const GantryPlan plan;
    const CheckedPlan before = plan.check.whole(beadsBetween(ends));
    std::set<std::size_t> changed;
    for (int i = 0; i < 2; ++i) {
      const auto layer = static_cast<std::size_t>(random.uniform(0.0, 13.999));
      ends[layer].second = 0.5 * (ends[layer].first + ends[layer].second);
      changed.insert({layer, std::min<std::size_t>(13, layer + 1)});  // the travel from there too
    }
    const Toolpath after = beadsBetween(ends);
    const CheckedPlan again = plan.check.again(after, before);
    const CheckedPlan whole = plan.check.whole(after);
    RC_ASSERT(foundIn(again.check, changed) == foundIn(whole.check, changed));
    const std::set<WaypointIndex> by_again = placesOf(again.check);
    const std::set<WaypointIndex> by_whole = placesOf(whole.check);
    RC_ASSERT(std::includes(by_again.begin(), by_again.end(), by_whole.begin(), by_whole.end()));
  }));
}

TEST(PlanCheck, KeepsWhatItFoundWhereNothingChanges) {
  const GantryPlan plan;
  const Toolpath beads = beadsBetween({{{0, -40, 45}, {0, 40, 45}}, {{10, -40, 5}, {10, 40, 5}}});
  const CheckedPlan before = plan.check.whole(beads);
  ASSERT_GT(before.hindered(), 0U);
  const CheckedPlan again = plan.check.again(beads, before);
  EXPECT_EQ(foundIn(again.check, {0, 1}), foundIn(before.check, {0, 1}));
}

TEST(MachineFit, IsClearByAWholeCheckAndLeavesOutWhatTheHeadHasNoRoomFor) {
  GantryPlan plan;
  plan.job.settings.volumetric.largest_left_out_percent = 50.0;
  std::vector<std::pair<Point3, Point3>> ends;
  for (int i = 0; i < 4; ++i) ends.push_back({{-50, -40.0 + 2.0 * i, 5}, {50, -40.0 + 2.0 * i, 5}});
  ends.push_back({{45, -45, 45}, {45, 45, 45}});
  for (int i = 0; i < 4; ++i) ends.push_back({{-50, 10.0 + 2.0 * i, 5}, {0, 10.0 + 2.0 * i, 5}});
  ends.push_back({{20, 30, 5}, {50, 30, 5}});
  const MachineFit fit = fitToMachine(beadsBetween(ends), plan.request, plan.lead, plan.nobody);
  EXPECT_GT(fit.hindered, 0U);
  EXPECT_EQ(fit.still_hindered, 0U);
  EXPECT_GT(fit.left_out_mm3, 0.0);
  EXPECT_TRUE(plan.check.whole(fit.toolpath).check.isClear());
  for (std::size_t l = 0; l < 9; ++l) EXPECT_EQ(fit.toolpath.layers[l].paths.size(), 2U) << l;
  const ThreadLimit limit(1);
  const MachineFit by_one = fitToMachine(beadsBetween(ends), plan.request, plan.lead, plan.nobody);
  EXPECT_EQ(toolpathId(by_one.toolpath), toolpathId(fit.toolpath)) << "of one thread";
}

TEST(MachineFit, LeavesAPlanAsItWasWhereTooMuchWouldBeLeftOut) {
  GantryPlan plan;
  plan.job.settings.volumetric.largest_left_out_percent = 0.0;
  const Toolpath beads = beadsBetween({{{0, -40, 45}, {0, 40, 45}}, {{10, -40, 5}, {10, 40, 5}}});
  const MachineFit fit = fitToMachine(beads, plan.request, plan.lead, plan.nobody);
  EXPECT_GT(fit.hindered, 0U);
  EXPECT_EQ(fit.still_hindered, fit.hindered);
  EXPECT_EQ(toolpathId(fit.toolpath), toolpathId(beads));
}

}  // namespace
}  // namespace lamina
