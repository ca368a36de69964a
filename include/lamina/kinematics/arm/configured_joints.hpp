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

/// @throws InvalidConfig if the kinematic model is no six-axis arm; so do all below
SixJoints sixJointsOf(const KinematicModel& arm, const JointValues& values);

/// The values with those of the six joints replaced.
JointValues withSixJoints(const KinematicModel& arm, JointValues values, const SixJoints& joints);

/// The joints by which an arm stands at a pose in a configuration: the way that `cfx` says, joints 1, 4 and 6
/// in the quarter turns that `cf1`, `cf4` and `cf6` say, but for 1e-4 rad of rounding.
/// @param near  external axes stand as here
/// @return nothing if the pose cannot be reached so; limits are not looked at
std::optional<JointValues> configuredJoints(const KinematicModel& arm,
                                            const Eigen::Isometry3d& bed_from_nozzle,
                                            const AbbConfiguration& configuration, const JointValues& near);

/// The joints nearest to others by which an arm comes to a pose, as a controller that looks at no
/// configurations goes there: of all ways and whole turns that whose greatest turn is the least.
/// @param near  external axes stand as here
/// @return nothing if the pose is out of reach; limits are not looked at
std::optional<JointValues> followingJoints(const KinematicModel& arm,
                                           const Eigen::Isometry3d& bed_from_nozzle, const JointValues& near);

}  // namespace lamina
