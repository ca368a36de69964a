// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "streaming/upload/machine_report.hpp"

namespace lamina {

/// A file's name as RepRapFirmware gives it, below its folder of programs: "0:/gcodes/a/b.g" as "a/b.g".
std::string belowPrograms(const std::string& name);

/// What RepRapFirmware's object model says.
/// @param model  with the keys state, job, heat and move
MachineReport reportOf(const nlohmann::json& model);

/// The lines of what RepRapFirmware says that tell of an error, or of a command that was not run.
std::vector<std::string> complaintsIn(const std::string& said);

/// The commands that turn every heater off: of the bed, of chambers, and of each of the tools.
/// @param tools  the object model's list of them
std::string heatersOffCommands(const nlohmann::json& tools);

/// The command that brings the end of a print nearer: it can be cancelled only while it is paused.
std::string cancelCommand(PrintState state);

}  // namespace lamina
