// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace lamina {

/// What a placeholder stands for; empty leaves out the line that holds it.
/// @throws InvalidConfig if there is no placeholder of that name
using PlaceholderValue = std::function<std::string(const std::string& name)>;

/// Lines with what stands in braces replaced, every line ended. Lines with a placeholder that has no value
/// are left out.
/// @param key  of the setting the lines come from, for the error
/// @throws InvalidConfig if a brace is not closed, and what `value` throws
std::string expandPlaceholders(const std::string& key, const std::string& lines,
                               const PlaceholderValue& value);

}  // namespace lamina
