// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "base/strict_yaml.hpp"
#include "lamina/kinematics/arm/arm_controller.hpp"

namespace lamina {

/// The controller that the key `controller` of a cell file states.
/// @throws InvalidConfig naming the line
ArmController armControllerFrom(const StrictYaml& node);

/// The element of a description that states a controller.
std::string controllerText(const ArmController& controller);

}  // namespace lamina
