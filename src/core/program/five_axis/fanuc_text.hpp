// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/program/five_axis/five_axis_settings.hpp"

namespace lamina {

/// Lines of a program as a Fanuc control takes them: comments in brackets and capitals, and a decimal point
/// in each word of an axis or feed, without which the control counts in its least increment.
/// @param lines  whole ones, with comments behind `;`
std::string fanucText(std::string_view lines);

/// The line that was written so, its comment behind `;` again; any other line as it is.
std::string fromFanucText(std::string_view line);

/// The line behind the first `%`: the letter O with four digits, or eight where four do not hold the number;
/// or the name in angle brackets.
/// @throws InvalidConfig if the name is longer than 32 characters or holds others than capitals, digits, + -
///   _ and .
std::string fanucProgramName(const FiveAxisSettings& settings);

}  // namespace lamina
