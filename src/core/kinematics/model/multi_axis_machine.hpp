// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <memory>
#include <string>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Kinematic model of a machine with three linear axes x, y and z and up to two rotary ones of a, b and c, in
/// any order between bed and nozzle and at any angles. A branch is a side of the plane of both rotary axes.
/// @throws InvalidConfig as `serialChain`; if any other joint moves, the linear axes do not span space, two
///   rotary ones are parallel, or the last rotary one turns about the tool axis
std::unique_ptr<KinematicModel> multiAxisMachine(const urdf::ModelInterface& model, const std::string& text);

}  // namespace lamina
