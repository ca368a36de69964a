// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "job/arm/clear_branches.hpp"
#include "job/modes/travels_over_part.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Plans the travels of a toolpath whose beads are final, as `leadTravels` does.
using LeadTravels = std::function<TravelsOverPart(Toolpath&)>;

/// A toolpath with its travels planned, and the parts of it that the machine cannot run.
struct CheckedPlan {
  Toolpath toolpath;
  TravelsOverPart travels;
  MachineCheck check;

  std::size_t hindered() const { return check.faults.size() + check.collisions.size(); }
};

/// Limits by which a plan is checked.
enum class PlanLimits {
  Tight,  ///< slightly tighter: joints move differently once the part is elsewhere or a layer is slowed down
  AsRun,  ///< those by which a program is refused
};

/// Checks a plan as that of a program is (`checkedRun`).
class PlanCheck {
 public:
  /// @param request, lead, progress  must outlive the check
  /// @throws InvalidConfig as `kinematicModelOf`
  PlanCheck(const PlanningRequest& request, const LeadTravels& lead, Progress& progress,
            PlanLimits limits = PlanLimits::Tight);

  const KinematicModel& model() const { return *model_; }

  /// Checks a whole toolpath.
  /// @param beads  toolpath whose travels are not planned yet
  /// @throws as `runOn` and `checkRun`
  CheckedPlan whole(Toolpath beads) const;

  /// Checks only the layers that differ from an earlier check, and their neighbours, through which the joints
  /// pass; findings for all other layers are taken over. Valid only if nothing is deposited that was not
  /// there before. If joints change in layers farther off, only `whole` shows it.
  /// @param beads   toolpath whose travels are not planned yet, with as many layers as `before`
  /// @param before  result of any check of the same part
  /// @throws as `whole`
  CheckedPlan again(Toolpath beads, const CheckedPlan& before) const;

  /// Checks some layers of a toolpath, whose travels are taken as they are. All other layers stand as solid
  /// material once they are passed; joints begin anew in each range (`ToolpathExcerpt`).
  /// @throws as `whole`
  MachineCheck of(const ToolpathExcerpt& excerpt) const;

 private:
  MachineCheck checked(const RunPlanner& plan) const;

  const PlanningRequest& request_;
  const LeadTravels& lead_;
  Progress& progress_;
  std::unique_ptr<KinematicModel> model_;
  CheckedMachine machine_;
  JointPathSettings joints_;
  ClearanceSettings clearance_;
};

}  // namespace lamina
