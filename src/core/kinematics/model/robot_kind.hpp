// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <optional>
#include <string>

namespace lamina {

/// Name of a joint by which a platform is recognised.
inline constexpr const char* kPlatformJoint = "crank_1";

/// "arm" or "platform"; nothing if the model has an axis x or is of no known kind. A model is an arm if it
/// has at least three rotary joints between its root and its nozzle, whatever their names.
std::optional<std::string> robotKind(const urdf::ModelInterface& model);

}  // namespace lamina
