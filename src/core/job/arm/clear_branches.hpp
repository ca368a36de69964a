// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "lamina/base/progress.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/kinematics/joint_path/joint_guard.hpp"
#include "lamina/verification/collision/checked_machine.hpp"
#include "lamina/verification/collision/clearance_settings.hpp"

namespace lamina {

/// A run of a part, and what stands in its way.
struct CheckedRun {
  KinematicModelRun run;
  MachineCheck check;
};

/// Plans a run with joint values that a guard allows.
using RunPlanner = std::function<KinematicModelRun(const JointGuard&)>;

/// Plans a run with the guard of a machine, and checks it. A six-axis arm is led without the branches with
/// which its links run into the bed or another link: the run is planned again without those that collide,
/// until one is clear, three times at most. A link that is rigid with the nozzle is in the bed with any
/// branch.
/// @return the clear run; otherwise the one with the fewest findings, the first of these
/// @throws as `plan`, `checkRun`
CheckedRun checkedRun(const CheckedMachine& machine, const RunPlanner& plan,
                      const ClearanceSettings& clearance, Progress& progress);

}  // namespace lamina
