// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lamina/program/program_frame.hpp"
#include "lamina/program/program_settings.hpp"

namespace lamina {

/// Of the nozzle of a tool from that of tool 0, along the axes that the program speaks [mm]. 0 of tools
/// beyond the settings' list.
Point3 toolOffset(std::uint32_t tool, const ProgramSettings& settings, const ProgramFrame& frame);

/// Comment lines that state the offsets that positions take into account, with 17 digits: `;TOOL_OFFSET:1 30
/// 0 0`. None of those that are 0.
std::string toolOffsetComments(const ProgramSettings& settings, const ProgramFrame& frame);

/// Takes in a comment without its semicolon; others change nothing.
/// @throws InvalidProgram if it is one of these, and not the number of a tool and three numbers
void readToolOffset(std::string_view comment, std::vector<Point3>& offsets_mm);

}  // namespace lamina
