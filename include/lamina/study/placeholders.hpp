// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

namespace lamina {

/// Names that stand in braces: `{pitch_mm}`. A name starts with a letter or underscore and goes on with
/// letters, digits, underscores and dots; any other text in braces stands for itself.
std::vector<std::string> placeholdersIn(const std::string& text);

/// The text with its placeholders replaced, once: what is put in is not looked into.
/// @throws InvalidConfig naming a placeholder that has no value
std::string filledIn(const std::string& text, const std::map<std::string, std::string>& values);

}  // namespace lamina
