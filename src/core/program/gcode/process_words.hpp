// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "lamina/program/program_settings.hpp"
#include "lamina/toolpath/toolpath_event.hpp"

namespace lamina {

/// Appends an event as lines of G-code: `G4 P` in the units of the dialect, `M106 S` from 0 to 255 or `M107`,
/// `pause.code` with the message, `;PART:` with the name; machine code unchanged.
void writeEvent(const ToolpathEvent& event, const ProgramSettings& settings, std::string& text);

/// The event of a command that is not a motion: `M106`, `M107`, `M0`, `M1`, `M226`, `M291` with S2, `M600`,
/// `M601`, `PAUSE`. Nothing for other commands, and for fans other than the first (P).
std::optional<ToolpathEvent> readEvent(std::string_view command);

/// The part mark of a comment `PART:name`; nothing for other comments.
std::optional<PartMark> readPartMark(std::string_view comment);

/// The tool of a command `T3`; nothing for other commands.
std::optional<std::uint32_t> readTool(std::string_view command);

}  // namespace lamina
