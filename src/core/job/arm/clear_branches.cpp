// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/arm/clear_branches.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "lamina/kinematics/arm/abb_configuration.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"

namespace lamina {
namespace {

constexpr int kMostPlans = 3;  // of the second ones

/// Forbids solutions of some branches, and what another guard forbids.
class BranchGuard final : public JointGuard {
 public:
  BranchGuard(const JointGuard& guard, const KinematicModel& arm, const std::set<int>& branches)
      : guard_(guard), arm_(arm), branches_(branches) {}

  bool allows(const JointValues& values) const override {
    return guard_.allows(values) && !isForbidden(values);
  }

  std::string hindrance(const JointValues& values) const override {
    std::string reason = guard_.hindrance(values);
    if (reason.empty() && isForbidden(values)) reason = "links of the arm collide elsewhere in this branch";
    return reason;
  }

 private:
  bool isForbidden(const JointValues& values) const {
    return branches_.count(abbConfiguration(arm_, values).cfx) > 0;
  }

  const JointGuard& guard_;
  const KinematicModel& arm_;
  const std::set<int>& branches_;
};

/// Whether a link runs into a body of the machine, but for one that is in the bed with any branch, such as
/// the nozzle. With the part any branch may collide, since it is where the tool is.
bool isOfBranch(const Finding& finding, const RigidGroup& at_nozzle) {
  if (finding.meeting.find(" in link '") != std::string::npos) return true;
  if (finding.meeting.find(" in the bed") == std::string::npos) return false;
  const auto isMet = [&](const std::string& link) {
    return finding.meeting.find("link '" + link + "' in the bed") != std::string::npos;
  };
  return std::none_of(at_nozzle.links.begin(), at_nozzle.links.end(), isMet);
}

const RigidGroup& groupOfNozzle(const LinkBodies& bodies) {
  const auto holdsNozzle = [](const RigidGroup& group) {
    return std::find(group.links.begin(), group.links.end(), "nozzle") != group.links.end();
  };
  return *std::find_if(bodies.groups.begin(), bodies.groups.end(), holdsNozzle);
}

/// Of the waypoints at which links run into bodies of the machine.
std::set<int> collidingBranches(const CheckedRun& checked, const CheckedMachine& machine) {
  std::set<WaypointIndex> places;
  const RigidGroup& at_nozzle = groupOfNozzle(machine.bodies());
  for (const Finding& finding : checked.check.collisions)
    if (isOfBranch(finding, at_nozzle)) places.insert(finding.at);
  std::set<int> branches;
  const JointPath& path = checked.run.path;
  for (std::size_t i = 0; i < path.at.size() && !places.empty(); ++i)
    if (places.count(checked.run.divided.originalOf(path.at[i])) > 0)
      branches.insert(abbConfiguration(machine.model(), path.values[i]).cfx);
  return branches;
}

std::size_t placesIn(const CheckedRun& checked) {
  return checked.check.faults.size() + checked.check.collisions.size();
}

}  // namespace

CheckedRun checkedRun(const CheckedMachine& machine, const RunPlanner& plan,
                      const ClearanceSettings& clearance, Progress& progress) {
  const auto planned = [&](const JointGuard& guard) {
    CheckedRun checked{plan(guard), {}};
    checked.check = checkRun(checked.run, machine, clearance, progress);
    return checked;
  };
  CheckedRun best = planned(machine.guard());
  const KinematicModel& arm = machine.model();
  if (!isSixAxisArm(arm) || !best.run.path.isRunnable() || best.check.isClear()) return best;
  std::set<int> forbidden = collidingBranches(best, machine);
  const BranchGuard guard(machine.guard(), arm, forbidden);
  std::size_t known = 0;
  for (int plans = 0; plans < kMostPlans; ++plans) {
    const bool is_further = forbidden.size() > known;
    if (!is_further || best.check.isClear()) break;
    known = forbidden.size();
    CheckedRun again = planned(guard);
    if (!again.run.path.isRunnable()) break;
    forbidden.merge(collidingBranches(again, machine));
    if (placesIn(again) < placesIn(best)) best = std::move(again);
  }
  return best;
}

}  // namespace lamina
