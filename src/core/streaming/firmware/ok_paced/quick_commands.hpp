// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "program/gcode/command_words.hpp"

namespace lamina {

/// Whether a command is answered as soon as it is queued: motions and settings, not commands that may run a
/// macro, wait or home.
inline bool isQuickCommand(std::string_view command) {
  constexpr std::array<std::string_view, 16> kQuick = {"G0",   "G1",   "G2",   "G3",  "G90", "G91",
                                                       "G92",  "G20",  "G21",  "M82", "M83", "M104",
                                                       "M106", "M107", "M140", "M117"};
  return isAnyCommand(command, kQuick);
}

}  // namespace lamina
