// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/joint_path/rung_store.hpp"
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"

namespace lamina {

/// Inputs for planning joint values several times, for toolpaths that share most stations. The objects
/// referred to must outlive it.
struct JointPlanning {
  const GuardedModel& guarded;
  const JointPathSettings& settings;
  RungStore& rungs;  ///< rungs of this model and these settings only
};

/// As with a guarded model alone, with the same result. Rungs in the store are not solved again; newly solved
/// rungs are stored.
JointPath planJointPath(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                        const JointPlanning& planning, Progress& progress);

}  // namespace lamina
