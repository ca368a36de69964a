// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/arm/clear_branches.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "lamina/kinematics/arm/abb_configuration.hpp"
#include "lamina/kinematics/joint_path/divided_joint_path.hpp"

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

/// With the part any branch may collide, since it is where the tool is.
bool isOfMachine(const Finding& finding) {
  return finding.meeting.find(" in the bed") != std::string::npos ||
         finding.meeting.find(" in link '") != std::string::npos;
}

/// Of the waypoints at which links run into bodies of the machine.
std::set<int> collidingBranches(const CheckedRun& checked, const KinematicModel& arm) {
  std::set<WaypointIndex> places;
  for (const Finding& finding : checked.check.collisions)
    if (isOfMachine(finding)) places.insert(finding.at);
  std::set<int> branches;
  const JointPath& path = checked.run.path;
  for (std::size_t i = 0; i < path.at.size() && !places.empty(); ++i)
    if (places.count(checked.run.divided.originalOf(path.at[i])) > 0)
      branches.insert(abbConfiguration(arm, path.values[i]).cfx);
  return branches;
}

}  // namespace

CheckedRun withClearBranches(CheckedRun first, const CheckedMachine& machine, const RunRequest& request,
                             Progress& progress) {
  const KinematicModel& arm = machine.model();
  if (!isSixAxisArm(arm) || !first.run.path.isRunnable()) return first;
  std::set<int> forbidden = collidingBranches(first, arm);
  const BranchGuard guard(machine.guard(), arm, forbidden);
  for (int plans = 0, known = 0; plans<kMostPlans&&static_cast<int>(forbidden.size())> known; ++plans) {
    known = static_cast<int>(forbidden.size());
    DividedJointPath planned =
        planDividedJointPath(request.toolpath, request.bed_from_part, {arm, guard}, request.joints, progress);
    CheckedRun again{{std::move(planned.divided), request.bed_from_part, std::move(planned.joints), {}}, {}};
    if (!again.run.path.isRunnable()) return first;
    again.check = checkRun(again.run, machine, request.clearance, progress);
    if (again.check.isClear()) return again;
    forbidden.merge(collidingBranches(again, arm));
  }
  return first;
}

}  // namespace lamina
