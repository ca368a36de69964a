// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace lamina {

/// "; did you mean '...'?" with the profile that somebody may have meant who wrote "CR-30", "PLA" or "mk3s":
/// the shortest name that holds what is given, of both letters and digits alone, in small letters. Without
/// one, the name that `suggestionFor` finds; empty if there is none either.
std::string profileSuggestion(const std::vector<std::string>& names, const std::string& given);

}  // namespace lamina
