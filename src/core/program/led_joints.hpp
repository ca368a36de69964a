// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// The joints at the end of a straight motion of any length, during which a controller keeps the solution
/// with which it began. The external axes move steadily to their values in `to`.
/// @param from  joints at the beginning
/// @param to  joints with the external axes as they are at the end; values of the other joints are ignored
/// @return nothing if a place on the line is out of reach; limits of joints are not checked
std::optional<JointValues> ledJoints(const KinematicModel& arm, const JointValues& from,
                                     const Eigen::Isometry3d& bed_from_nozzle, const JointValues& to);

}  // namespace lamina
