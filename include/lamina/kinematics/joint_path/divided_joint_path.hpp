// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/joint_path/joint_path_planner.hpp"
#include "lamina/kinematics/joint_path/motion_division.hpp"

namespace lamina {

/// Deviation of the nozzle from a motion's interpolation, half way between two waypoints, if all joints move
/// at constant speed.
struct MotionDeviation {
  double tip_mm = 0.0;     ///< from the straight line
  double tool_axis = 0.0;  ///< from the orientation in between, at constant angular speed [rad]
};

/// Deviations of the motions, one for each waypoint of the joint path, for the motion that ends there. Zero
/// where no deviation limit applies: where joint values are missing, at the start of a path, where a joint is
/// wound back while depositing, and on a travel on which a rotary joint turns by more than
/// `joints.max_turn_deg`. Jumps keep their deviation, so that they are divided.
std::vector<MotionDeviation> motionDeviations(const JointPath& path, const Toolpath& toolpath,
                                              const KinematicModel& model, const JointPathSettings& settings);

/// Number of steps of each motion, for `divided`, that brings the deviations within the tolerances.
std::vector<int> stepsAgainst(const std::vector<MotionDeviation>& deviations, const MotionDivision& division);

/// A toolpath divided finely enough that joints at constant speed lead the nozzle along it, and its joint
/// values.
struct DividedJointPath {
  DividedToolpath divided;
  JointPath joints;  ///< of the divided toolpath
  /// Greatest remaining deviations; above the tolerances if `kMostDivisions` were not enough.
  MotionDeviation greatest;
};

/// Greatest number of times that motions are checked half way and divided again.
constexpr int kMostDivisions = 4;

/// Divides a toolpath by the greatest steps of `settings.division` and plans its joint values. Motions that
/// exceed the tolerances of `settings.division` are divided further and all joint values planned again, at
/// most `kMostDivisions` times.
/// @throws as `planJointPath`
DividedJointPath planDividedJointPath(Toolpath toolpath, const Eigen::Isometry3d& bed_from_part,
                                      const KinematicModel& model, const JointPathSettings& settings,
                                      Progress& progress);

/// The same, but only joint values that the guard allows are planned.
DividedJointPath planDividedJointPath(Toolpath toolpath, const Eigen::Isometry3d& bed_from_part,
                                      const GuardedModel& guarded, const JointPathSettings& settings,
                                      Progress& progress);

}  // namespace lamina
