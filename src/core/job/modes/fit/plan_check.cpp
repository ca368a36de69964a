// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/fit/plan_check.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "job/joint_program.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/kinematics/machine_choice.hpp"

namespace lamina {
namespace {

// Of what `lamina check` allows.
constexpr double kOfSlowdown = 0.5;
constexpr double kOfTolerance = 0.8;

bool isHeldAlike(const Path& a, const Path& b) {
  const auto isSame = [](const Eigen::Quaterniond& one, const Eigen::Quaterniond& other) {
    return one.coeffs() == other.coeffs();
  };
  const std::vector<Eigen::Quaterniond>& held = a.orientation.values();
  const std::vector<Eigen::Quaterniond>& other = b.orientation.values();
  return std::equal(held.begin(), held.end(), other.begin(), other.end(), isSame);
}

/// Of two states of one path: its feeds and beads are as they were where its waypoints are.
bool isAlike(const Path& a, const Path& b) {
  return a.role == b.role && a.is_closed == b.is_closed && a.points == b.points && isHeldAlike(a, b);
}

/// The layers that differ between two states of a toolpath, and one on either side.
std::vector<LayerRange> changedStretches(const Toolpath& before, const Toolpath& after) {
  std::vector<LayerRange> stretches;
  const std::size_t count = after.layers.size();
  for (std::size_t l = 0; l < count; ++l) {
    const std::vector<Path>& was = before.layers[l].paths;
    const std::vector<Path>& is = after.layers[l].paths;
    if (std::equal(was.begin(), was.end(), is.begin(), is.end(), isAlike)) continue;
    const std::size_t first = l > 0 ? l - 1 : 0;
    const std::size_t end = std::min(count, l + 2);
    if (!stretches.empty() && first <= stretches.back().end)
      stretches.back().end = end;
    else
      stretches.push_back({first, end});
  }
  return stretches;
}

/// What was found before in other layers, and what is found now in these.
std::vector<Finding> replaced(const std::vector<Finding>& before, std::vector<Finding> now,
                              const std::vector<LayerRange>& stretches) {
  const auto isElsewhere = [&](const Finding& finding) {
    return std::none_of(stretches.begin(), stretches.end(), [&](const LayerRange& stretch) {
      return finding.at.layer >= stretch.first && finding.at.layer < stretch.end;
    });
  };
  std::copy_if(before.begin(), before.end(), std::back_inserter(now), isElsewhere);
  std::stable_sort(now.begin(), now.end(),
                   [](const Finding& a, const Finding& b) { return a.at.layer < b.at.layer; });
  return now;
}

}  // namespace

PlanCheck::PlanCheck(const PlanningRequest& request, const LeadTravels& lead, Progress& progress,
                     PlanLimits limits)
    : request_(request),
      lead_(lead),
      progress_(progress),
      model_(kinematicModelOf(request.job.settings.machine)),
      machine_(*model_),
      joints_(jointsOf(request.job, *model_)),
      clearance_(request.job.settings.clearance) {
  if (limits == PlanLimits::AsRun) return;
  joints_.max_slowdown = std::max(1.0, kOfSlowdown * joints_.max_slowdown);
  clearance_.tolerance_mm *= kOfTolerance;
}

CheckedPlan PlanCheck::whole(Toolpath beads) const {
  const TravelsOverPart travels = lead_(beads);
  MachineCheck check = checked([&](const JointGuard& guard) {
    return runOn(GuardedModel{*model_, guard}, beads, request_.bed_from_part, joints_, progress_);
  });
  return {std::move(beads), travels, std::move(check)};
}

CheckedPlan PlanCheck::again(Toolpath beads, const CheckedPlan& before) const {
  const TravelsOverPart travels = lead_(beads);
  const std::vector<LayerRange> stretches = changedStretches(before.toolpath, beads);
  MachineCheck check = of({beads, stretches});
  check.faults = replaced(before.check.faults, std::move(check.faults), stretches);
  check.collisions = replaced(before.check.collisions, std::move(check.collisions), stretches);
  return {std::move(beads), travels, std::move(check)};
}

MachineCheck PlanCheck::of(const ToolpathExcerpt& excerpt) const {
  return checked([&](const JointGuard& guard) {
    return runOn(GuardedModel{*model_, guard}, excerpt, request_.bed_from_part, joints_, progress_);
  });
}

MachineCheck PlanCheck::checked(const RunPlanner& plan) const {
  return checkedRun(machine_, plan, clearance_, progress_).check;
}

}  // namespace lamina
