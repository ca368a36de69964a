// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lamina/program/program_settings.hpp"
#include "lamina/toolpath/toolpath_event.hpp"

namespace lamina {

/// Appends an event as commands of the controller: waits in seconds (`G4 P` of LinuxCNC, `G4 F` of Siemens)
/// or milliseconds (Fanuc), the fan as LinuxCNC's analogue output 0 in step with the motion (`M67 E0 Q`),
/// pauses as `M0`. Fanuc and Siemens have no command for a fan, so a comment states its speed. In the generic
/// dialect as `writeEvent`.
void writeFiveAxisEvent(const ToolpathEvent& event, const ProgramSettings& settings, std::string& text);

/// The event that `writeFiveAxisEvent` has written as this command; nothing for other commands.
/// @throws InvalidProgram if a wait has no duration of 0 to 1e6 s
std::optional<ToolpathEvent> readFiveAxisEvent(std::string_view command, const ProgramSettings& settings);

}  // namespace lamina
