// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <string>

#include "lamina/kinematics/cartesian/machine_bodies.hpp"

namespace lamina {

/// The shape of a `<collision>` element; a cylinder whose collision is named `cone` stands for the cone
/// inscribed in it.
/// @throws InvalidConfig if it is a mesh or has a size that is not positive, naming the link
BodyShape shapeOf(const urdf::Collision& collision, const std::string& link);

}  // namespace lamina
