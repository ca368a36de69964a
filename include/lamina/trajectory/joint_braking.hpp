// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// How long joints take that come to rest together, each with the same deceleration all the way [s].
/// @param brake_s  that a joint takes from its greatest speed
double brakeTime(const JointValues& velocity, const std::vector<DrivenJoint>& joints, double brake_s);

/// How long they may take at most, so that none comes to rest beyond its limits [s]; infinite if all rest.
double brakeRoom(const JointValues& position, const JointValues& velocity,
                 const std::vector<DrivenJoint>& joints);

}  // namespace lamina
