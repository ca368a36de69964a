// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

namespace lamina {

/// The names of the placeholders in a text, which are names in braces: `{pitch_mm}`. A name starts with a
/// letter or underscore and continues with letters, digits, underscores and dots; other text in braces is no
/// placeholder.
std::vector<std::string> placeholdersIn(const std::string& text);

/// The text with its placeholders replaced by their values. Placeholders within values are not replaced.
/// @throws InvalidConfig naming a placeholder that has no value
std::string filledIn(const std::string& text, const std::map<std::string, std::string>& values);

}  // namespace lamina
