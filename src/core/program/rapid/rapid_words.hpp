// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/decimals.hpp"

namespace lamina {

/// Name of the variable that switches the process off for a dry run.
constexpr std::string_view kRapidDryFlag = "lamina_dry";

/// Beginning of the note on a level: its process value, its output, and the output's value for each unit.
constexpr std::string_view kRapidLevel = "level";

/// Beginning of the note on an external axis: its joint, its name on the controller, 1 or -1, and its zero.
constexpr std::string_view kRapidExternal = "external";

/// External axes of a target as printed in [Flores2018]; RAPID has six.
constexpr std::size_t kThesisAxes = 5;

/// Name of the trigger that sets a level during a move: "lamina_level_1" for the first level.
std::string rapidLevelTrigger(std::size_t level);

/// Refuses a name that cannot be declared in RAPID.
/// @param key  what is named, for the error
/// @throws InvalidConfig if the name is no identifier, or a reserved word
void requireRapidName(const std::string& key, const std::string& name);

/// Speed [mm/s] of the tool centre of a predefined speed, v5 to v7000; nothing for other names.
std::optional<double> rapidSpeed(std::string_view name);

/// Whether a name is that of a predefined zone: fine, z0 to z200.
bool isRapidZone(std::string_view name);

}  // namespace lamina
