// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lamina/program/program_frame.hpp"
#include "lamina/program/program_settings.hpp"

namespace lamina {

/// Offset of a tool's nozzle from that of tool 0, along the axes of the program [mm]. 0 for a tool beyond the
/// settings' list.
Point3 toolOffset(std::uint32_t tool, const ProgramSettings& settings, const ProgramFrame& frame);

/// Comment lines that state the tool offsets contained in the positions, with 17 digits: `;TOOL_OFFSET:1 30 0
/// 0`. Offsets of 0 are omitted.
std::string toolOffsetComments(const ProgramSettings& settings, const ProgramFrame& frame);

/// Reads the tool offset that a comment, given without its semicolon, states; other comments change nothing.
/// @throws InvalidProgram if the comment states an offset, but not as the number of a tool and three numbers
void readToolOffset(std::string_view comment, std::vector<Point3>& offsets_mm);

}  // namespace lamina
