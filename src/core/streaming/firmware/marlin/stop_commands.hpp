// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/streaming/firmware/marlin/marlin_firmware.hpp"
#include "streaming/job/used_outputs.hpp"

namespace lamina {

/// What stops the machine without waiting for the numbering to be agreed on, with ends of lines: firmware
/// that is busy heating may not answer for minutes, but runs these as soon as it can. What fits into its
/// receive buffer, the most dangerous first.
std::string urgentStop(const MarlinFirmware& firmware, const UsedOutputs& outputs,
                       const StreamSettings& settings);

/// The lines of a safe stop: motions end, and all is turned off that the program has turned on.
std::vector<std::string> safeStop(const MarlinFirmware& firmware, const UsedOutputs& outputs,
                                  const StreamSettings& settings);

/// Turns on the reports that the settings ask for; the last one first.
std::vector<std::string> reportsOn(const MarlinFirmware& firmware, const StreamSettings& settings);

/// Turns the reports off that the job has turned on: whoever talks to the machine next shall not find it
/// talking by itself.
std::vector<std::string> reportsOff(const MarlinFirmware& firmware, const StreamSettings& settings);

}  // namespace lamina
