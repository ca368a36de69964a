// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/program/five_axis/five_axis_settings.hpp"

namespace lamina {

/// Lines of a program in the form that a Fanuc control expects: comments in round brackets and capitals, and
/// a decimal point in every word of an axis or feed, as the control would otherwise count the number in its
/// least increment.
/// @param lines  whole lines, with comments after `;`
std::string fanucText(std::string_view lines);

/// The inverse of `fanucText` for one line, with its comment after `;`; a line of any other form is
/// unchanged.
std::string fromFanucText(std::string_view line);

/// The line of a Fanuc program that names it, after the first `%`: the letter O with four digits, or eight if
/// four do not hold the number; or the name in angle brackets.
/// @throws InvalidConfig if the name is longer than 32 characters or contains characters other than capitals,
///   digits, + - _ and .
std::string fanucProgramName(const FiveAxisSettings& settings);

}  // namespace lamina
