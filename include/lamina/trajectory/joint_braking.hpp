// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Time in which all joints come to rest together, each at constant deceleration [s].
/// @param brake_s  time in which a joint comes to rest from its greatest speed
double brakeTime(const JointValues& velocity, const std::vector<DrivenJoint>& joints, double brake_s);

/// Greatest time in which all joints may come to rest together, each at constant deceleration, without any of
/// them passing its limits [s]; infinite if all are at rest.
double brakeRoom(const JointValues& position, const JointValues& velocity,
                 const std::vector<DrivenJoint>& joints);

}  // namespace lamina
