// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Tolerance on the limits of joints for positions that a controller reports, as limits are rounded in the
/// controller [mm, rad].
constexpr double kJointLimitSlack = 1e-6;

/// Describes the first joint that is beyond its limits or not a number: "joint a at 1.2 deg; must be within
/// -1 to 1 deg". Nothing if all are within.
/// @param values  one for each joint [mm, rad]
std::optional<std::string> limitFault(const JointValues& values, const KinematicModel& model);

/// Describes a value of a joint with its bounds: "joint 'a' 1.2, expected -1 to 1" [mm, rad; per s].
std::string boundsText(const DrivenJoint& joint, double is, double low, double high);

}  // namespace lamina
