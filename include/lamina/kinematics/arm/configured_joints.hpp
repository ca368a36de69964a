// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "lamina/kinematics/arm/abb_configuration.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Values of an arm's six joints from the base to the nozzle [rad].
using SixJoints = Eigen::Matrix<double, 6, 1>;

/// The values of the six joints among all values of the model.
/// @throws InvalidConfig if the kinematic model is no six-axis arm, as do the functions below
SixJoints sixJointsOf(const KinematicModel& arm, const JointValues& values);

/// All values of the model, with those of the six joints replaced.
JointValues withSixJoints(const KinematicModel& arm, JointValues values, const SixJoints& joints);

/// The joint values with which an arm reaches a pose in a given configuration: the inverse solution with that
/// `cfx`, with joints 1, 4 and 6 in the quarters of `cf1`, `cf4` and `cf6`, with a tolerance of 1e-4 rad for
/// rounding.
/// @param near  values of the external axes, which are kept
/// @return nothing if the pose cannot be reached in that configuration; limits of joints are not checked
std::optional<JointValues> configuredJoints(const KinematicModel& arm,
                                            const Eigen::Isometry3d& bed_from_nozzle,
                                            const AbbConfiguration& configuration, const JointValues& near);

/// The joint values with which an arm reaches a pose if its controller ignores configurations: of all inverse
/// solutions and whole turns, the values whose greatest change of a joint is least.
/// @param near  values from which the arm comes; those of the external axes are kept
/// @return nothing if the pose is out of reach; limits of joints are not checked
std::optional<JointValues> followingJoints(const KinematicModel& arm,
                                           const Eigen::Isometry3d& bed_from_nozzle, const JointValues& near);

}  // namespace lamina
