// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/joint_path/rung_store.hpp"
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"

namespace lamina {

/// How joint values are planned, several times for toolpaths that have most stations in common. What it
/// refers to must outlive it.
struct JointPlanning {
  const GuardedModel& guarded;
  const JointPathSettings& settings;
  RungStore& rungs;  ///< of this model and these settings alone
};

/// As with a guarded model alone; rungs that are kept are not solved again, and those that are solved are
/// kept. The result is the same.
JointPath planJointPath(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                        const JointPlanning& planning, Progress& progress);

}  // namespace lamina
