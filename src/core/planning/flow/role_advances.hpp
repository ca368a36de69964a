// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "lamina/planning/flow/flow_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Whether any role has an advance.
bool hasAdvance(const FlowSettings& settings);

/// The advance of each role [s].
/// @throws InvalidConfig if a part of `advance_by_role` is not a role, '=' and a time from 0 to 10 s
std::array<double, kPathRoles> advancesOf(const FlowSettings& settings);

}  // namespace lamina
