// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace lamina {

/// The value of a placeholder. If it is empty, the line with the placeholder is left out.
/// @throws InvalidConfig if there is no placeholder of that name
using PlaceholderValue = std::function<std::string(const std::string& name)>;

/// The lines with each placeholder, a name in braces, replaced by its value, and a line end after every line.
/// Lines with a placeholder whose value is empty are left out.
/// @param key  key of the setting that holds the lines, for errors
/// @throws InvalidConfig if a brace is not closed; what `value` throws
std::string expandPlaceholders(const std::string& key, const std::string& lines,
                               const PlaceholderValue& value);

}  // namespace lamina
