// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/kinematics/joint_path/joint_guard.hpp"
#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Leads a kinematic model along a toolpath: at each waypoint the branch, the turn about the tool axis where
/// it is free, and the whole turns of its rotary joints, so that the joints move as little as can be, keep
/// away from their limits and from singularities, and rotary joints are wound back on travels only
/// (docs/machines/joint-paths.md).
///
/// Every waypoint that cannot be run is named, and the path goes on after it. Time and memory are linear in
/// the waypoints: 2 bytes for each sample of each branch of a waypoint. The same whatever the number of
/// threads.
/// @param toolpath  a toolpath without waypoints gives an empty path
/// @throws InvalidConfig if a setting is out of its bounds; InvalidInput if a joint's greatest speed is not
///   positive; Cancelled
JointPath planJointPath(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                        const KinematicModel& model, const JointPathSettings& settings, Progress& progress);

/// The same, with only those joint values that the guard allows. The guard is asked at waypoints only.
JointPath planJointPath(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                        const GuardedModel& guarded, const JointPathSettings& settings, Progress& progress);

}  // namespace lamina
