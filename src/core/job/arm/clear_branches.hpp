// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/base/progress.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/verification/collision/checked_machine.hpp"
#include "lamina/verification/collision/clearance_settings.hpp"

namespace lamina {

/// A run of a part, and what stands in its way.
struct CheckedRun {
  KinematicModelRun run;
  MachineCheck check;
};

/// What is run, and how it is planned and checked.
struct RunRequest {
  const Toolpath& toolpath;
  const Eigen::Isometry3d& bed_from_part;
  const JointPathSettings& joints;
  const ClearanceSettings& clearance;
};

/// A run of a six-axis arm without the branches with which links of the arm run into the bed or another link:
/// planned again without those that collide, until a run is clear, three times at most. The run that it began
/// with is returned if none is clear, if nothing of that kind collides, and for other machines.
/// @param first  the run without such a choice
/// @throws as `planDividedJointPath`, `checkRun`
CheckedRun withClearBranches(CheckedRun first, const CheckedMachine& machine, const RunRequest& request,
                             Progress& progress);

}  // namespace lamina
