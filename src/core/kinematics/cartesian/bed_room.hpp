// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <string>

#include "lamina/kinematics/cartesian/cartesian_machine.hpp"

namespace lamina {

/// Whether it is an arm or a platform, reported by joint_1 or crank_1: no machine of axes x, y and z.
bool isRobot(const urdf::ModelInterface& model);

/// A robot as slicing and placing see it: the room over the bodies of its bed, in which axes along the bed's
/// carry an upright nozzle. What of it the robot reaches, and how, a joint path reports.
/// @throws InvalidConfig if it has no link `bed`, or that no collision body
CartesianMachine roomOverBed(const urdf::ModelInterface& model, const std::string& text);

}  // namespace lamina
