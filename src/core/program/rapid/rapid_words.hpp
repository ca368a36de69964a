// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/decimals.hpp"

namespace lamina {

/// RAPID does not distinguish upper from lower case.
std::string lowerCase(std::string_view name);

/// @param key  what the name is for, for the error
/// @throws InvalidConfig if it is no identifier of RAPID, or a reserved word
void requireRapidName(const std::string& key, const std::string& name);

/// Speed of the tool centre [mm/s] if it is a speed that every controller has: v5 to v7000.
std::optional<double> rapidSpeed(std::string_view name);

/// Whether it is a zone that every controller has: fine, z0 to z200.
bool isRapidZone(std::string_view name);

}  // namespace lamina
