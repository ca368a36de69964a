// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Adds the prime tower of a plate that is laid layer by layer, with the purges that `tools.*` asks for; it
/// is of no part. Ways to another tool and from layer to layer are made anew, without wipes.
/// @param plate  tool by tool in each layer, with the marks of its parts [bed frame]
/// @throws InvalidConfig if layers lie in each other, which a tower cannot have; as `arrangeTools`
Toolpath withTower(Toolpath plate, const PlanSettings& settings);

}  // namespace lamina
