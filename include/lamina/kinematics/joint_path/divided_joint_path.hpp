// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/joint_path/joint_path_planner.hpp"
#include "lamina/kinematics/joint_path/motion_division.hpp"

namespace lamina {

/// How far the nozzle leaves its motions half way from a waypoint to the next, the joints going steadily.
struct MotionDeviation {
  double tip_mm = 0.0;     ///< from the straight line
  double tool_axis = 0.0;  ///< from the steady turn [rad]
};

/// One per waypoint of the joint path, of the motion that ends there. Zero where there are no joints, at the
/// start of a path, where a joint is wound up, and on a travel on which one turns by more than
/// `joints.max_turn_deg`: there nothing steady is asked. A jump has its deviation, so that it is divided.
std::vector<MotionDeviation> motionDeviations(const JointPath& path, const Toolpath& toolpath,
                                              const KinematicModel& model, const JointPathSettings& settings);

/// A toolpath divided finely enough for joints at constant speed to lead the nozzle along it, and the joints.
struct DividedJointPath {
  DividedToolpath divided;
  JointPath joints;          ///< of the divided toolpath
  MotionDeviation greatest;  ///< above the tolerances where `kMostDivisions` were not enough
};

/// Motions are checked half way and divided again so often, at most.
constexpr int kMostDivisions = 4;

/// Divides by the greatest steps of `settings.division`, leads the joints, divides where its tolerances are
/// not kept, and so on.
/// @throws as `planJointPath`
DividedJointPath planDividedJointPath(Toolpath toolpath, const Eigen::Isometry3d& bed_from_part,
                                      const KinematicModel& model, const JointPathSettings& settings,
                                      Progress& progress);

/// The same with joint values only that the guard allows.
DividedJointPath planDividedJointPath(Toolpath toolpath, const Eigen::Isometry3d& bed_from_part,
                                      const GuardedModel& guarded, const JointPathSettings& settings,
                                      Progress& progress);

}  // namespace lamina
