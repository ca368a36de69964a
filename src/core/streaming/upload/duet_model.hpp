// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "streaming/upload/machine_report.hpp"

namespace lamina {

/// A file name of RepRapFirmware relative to its folder of programs: "0:/gcodes/a/b.g" as "a/b.g".
std::string belowPrograms(const std::string& name);

/// The report of a machine from RepRapFirmware's object model.
/// @param model  with the keys state, job, heat and move
MachineReport reportOf(const nlohmann::json& model);

/// The lines of RepRapFirmware's output that report an error, or a command that was not run.
std::vector<std::string> complaintsIn(const std::string& said);

/// The commands that turn off every heater: of the bed, of chambers, and of each tool.
/// @param tools  list of tools in the object model
std::string heatersOffCommands(const nlohmann::json& tools);

/// The next command to cancel a print: first a pause, then the cancellation, which only a paused print
/// accepts.
std::string cancelCommand(PrintState state);

}  // namespace lamina
