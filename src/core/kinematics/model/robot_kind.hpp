// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <optional>
#include <string>

namespace lamina {

/// Joint by which platforms are recognised.
inline constexpr const char* kPlatformJoint = "crank_1";

/// "arm" or "platform"; nothing of what has an axis x, or is of no kind that is understood. An arm is what
/// has three rotary joints or more between its root and its nozzle, whatever their names.
std::optional<std::string> robotKind(const urdf::ModelInterface& model);

}  // namespace lamina
