// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "job/modes/travels_over_part.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Changes the travels of a toolpath whose beads are settled, as `leadTravels`.
using LeadTravels = std::function<TravelsOverPart(Toolpath&)>;

/// A toolpath whose travels are led, and what the machine cannot run of it.
struct CheckedPlan {
  Toolpath toolpath;
  TravelsOverPart travels;
  MachineCheck check;

  std::size_t hindered() const { return check.faults.size() + check.collisions.size(); }
};

/// Checks what is planned as `runOn` and `checkRun` do, a little more strictly: a part that stands elsewhere,
/// or a layer that is slowed down, is led otherwise.
class PlanCheck {
 public:
  /// @param request, lead, progress  must outlive the check
  /// @throws InvalidConfig as `kinematicModelOf`
  PlanCheck(const PlanningRequest& request, const LeadTravels& lead, Progress& progress);

  /// @param beads  its travels not led yet
  /// @throws as `runOn` and `checkRun`
  CheckedPlan whole(Toolpath beads) const;

  /// Looks only at layers that are not as they were, and at those beside them, through which the joints go
  /// on; of the others the findings are kept. To be trusted as far as nothing is deposited that was not
  /// before; where joints choose otherwise in layers farther off, only the whole check shows that.
  /// @param beads   its travels not led yet, with as many layers
  /// @param before  of the same part, any check
  /// @throws as `whole`
  CheckedPlan again(Toolpath beads, const CheckedPlan& before) const;

 private:
  MachineCheck checked(const KinematicModelRun& run) const;

  const PlanningRequest& request_;
  const LeadTravels& lead_;
  Progress& progress_;
  std::unique_ptr<KinematicModel> model_;
  JointPathSettings joints_;
  ClearanceSettings clearance_;
};

}  // namespace lamina
