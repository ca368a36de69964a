// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <Eigen/Core>
#include <string>

namespace lamina {

/// Name of the link at the end of an arm: the given one, else tool0, else flange, else the tip of the longest
/// chain.
/// @param named  empty for none
/// @throws InvalidConfig if there is no link of that name
std::string flangeOf(const urdf::ModelInterface& model, const std::string& named);

/// The axis of the last joint that moves the flange, in the flange's frame: its z is the cosine of the angle
/// between both.
/// @throws InvalidConfig if no joint moves it
Eigen::Vector3d flangeAxis(const urdf::ModelInterface& model, const std::string& flange);

/// The two turns (roll, pitch, yaw) of a flange that bring its z along its axis and against it, in words:
/// "[0, 90, 0] along it, or [0, -90, 0] against it".
std::string flangeTurns(const Eigen::Vector3d& axis);

}  // namespace lamina
