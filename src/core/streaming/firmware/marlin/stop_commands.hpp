// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/streaming/firmware/marlin/marlin_firmware.hpp"
#include "streaming/job/used_outputs.hpp"

namespace lamina {

/// Commands without line numbers, with ends of lines, that stop the machine. Firmware that is heating may not
/// answer for minutes, but runs these as soon as it can. They fit into its receive buffer, ordered by the
/// danger that they avert, greatest first.
std::string urgentStop(const MarlinFirmware& firmware, const UsedOutputs& outputs,
                       const StreamSettings& settings);

/// The lines of a safe stop: they end motions and switch off all that the program has switched on.
std::vector<std::string> safeStop(const MarlinFirmware& firmware, const UsedOutputs& outputs,
                                  const StreamSettings& settings);

/// Commands that switch off each tool that a temperature report names by its number.
std::vector<std::string> reportedToolsOff(const std::string& report);

/// Commands that switch off the chamber and each tool that a temperature report names, for a machine whose
/// program's outputs are not known.
std::vector<std::string> reportedHeatersOff(const std::string& report);

/// Whether a report that states targets has none above 0.
bool heatsNothing(const ReportedTemperatures& temperatures);

/// Whether a machine has ended a safe stop, by the temperatures that it reports after the lines of the stop.
bool isSafe(const ReportedTemperatures& temperatures, const StreamSettings& settings);

/// Commands that switch on the reports of the settings, in reverse order.
std::vector<std::string> reportsOn(const MarlinFirmware& firmware, const StreamSettings& settings);

/// Commands that switch off the reports of the settings: the machine sends none after the job.
std::vector<std::string> reportsOff(const MarlinFirmware& firmware, const StreamSettings& settings);

/// Remark at the end of a failure's message, where the machine has not confirmed the safe stop in time: what
/// is to be done.
/// @param is_halted  whether it has said that it halted: it hears nothing until it is reset
const char* unconfirmedStop(bool is_halted);

}  // namespace lamina
