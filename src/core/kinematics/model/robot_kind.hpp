// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <optional>
#include <string>

namespace lamina {

// Joints by which robots are recognised.
inline constexpr const char* kArmJoint = "joint_1";
inline constexpr const char* kPlatformJoint = "crank_1";

/// "arm" or "platform"; nothing of what has an axis x, or is of no kind that is understood.
std::optional<std::string> robotKind(const urdf::ModelInterface& model);

}  // namespace lamina
