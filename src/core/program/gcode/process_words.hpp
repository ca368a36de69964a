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

/// Appends an event as lines of G-code: `G4 P` in the units of the dialect, `M106 S` of 255 or `M107`,
/// `pause.code` with the message, `;PART:` with the name; code as it is.
void writeEvent(const ToolpathEvent& event, const ProgramSettings& settings, std::string& text);

/// The event of a command that is no motion: `M106`, `M107`, `M0`, `M1`, `M226`, `M291` with S2, `M600`,
/// `M601`, `PAUSE`. Fans other than the first (P) are none.
std::optional<ToolpathEvent> readEvent(std::string_view command);

/// The mark of a comment `PART:name`.
std::optional<PartMark> readPartMark(std::string_view comment);

/// The tool of a command `T3`.
std::optional<std::uint32_t> readTool(std::string_view command);

}  // namespace lamina
