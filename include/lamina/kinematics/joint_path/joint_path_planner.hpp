// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/kinematics/joint_path/joint_guard.hpp"
#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Plans the joint values of a kinematic model along a toolpath. At each waypoint it chooses the branch of
/// the inverse solution, the rotation about the tool axis if that is free, and the whole turns of rotary
/// joints, so that joints move as little as possible, keep away from their limits and from singularities, and
/// rotary joints are wound back on travels only (docs/machines/joint-paths.md).
///
/// Every waypoint that cannot be run is listed as a fault, and the path continues after it. Time and memory
/// are linear in the number of waypoints: 2 bytes for each sample of each branch of a waypoint. The result is
/// the same for any number of threads.
/// @param toolpath  without waypoints, the path is empty
/// @throws InvalidConfig if a setting is out of its bounds
/// @throws InvalidInput if a joint's greatest speed is not positive
/// @throws Cancelled
JointPath planJointPath(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                        const KinematicModel& model, const JointPathSettings& settings, Progress& progress);

/// The same, but only joint values that the guard allows are planned. The guard is asked at waypoints only.
JointPath planJointPath(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                        const GuardedModel& guarded, const JointPathSettings& settings, Progress& progress);

}  // namespace lamina
