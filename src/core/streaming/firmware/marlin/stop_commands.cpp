// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/marlin/stop_commands.hpp"

namespace lamina {

std::string urgentStop(const MarlinFirmware& firmware, const UsedOutputs& outputs,
                       const StreamSettings& settings) {
  std::string text;
  const auto add = [&text](const std::vector<std::string>& commands) {
    for (const std::string& command : commands) text += command + "\n";
  };
  add(firmware.interruption());
  add(firmware.stop());
  add(outputs.beamOff());
  if (!settings.keep_heaters_on) add(firmware.heatersOff());
  return text;
}

std::vector<std::string> safeStop(const MarlinFirmware& firmware, const UsedOutputs& outputs,
                                  const StreamSettings& settings) {
  std::vector<std::string> commands = firmware.stop();
  const auto add = [&commands](const std::vector<std::string>& more) {
    commands.insert(commands.end(), more.begin(), more.end());
  };
  add(outputs.beamOff());
  if (!settings.keep_heaters_on) {
    add(firmware.heatersOff());
    add(outputs.heatOff());
  }
  add(outputs.airOff());
  add(reportsOff(firmware, settings));
  return commands;
}

std::vector<std::string> reportedToolsOff(const std::string& report) {
  std::vector<std::string> commands;
  for (std::size_t at = report.find(" T"); at != std::string::npos; at = report.find(" T", at + 1)) {
    const std::size_t end = report.find_first_not_of("0123456789", at + 2);
    if (end == std::string::npos || end == at + 2 || report[end] != ':') continue;
    commands.push_back("M104 T" + report.substr(at + 2, end - at - 2) + " S0");
  }
  return commands;
}

std::vector<std::string> reportedHeatersOff(const std::string& report) {
  std::vector<std::string> commands = reportedToolsOff(report);
  commands.emplace_back("M141 S0");
  return commands;
}

bool heatsNothing(const ReportedTemperatures& temperatures) {
  const bool is_bed_off = !temperatures.bed_c || temperatures.bed_target_c == 0.0;
  return temperatures.nozzle_target_c == 0.0 && is_bed_off && temperatures.highest_target_c == 0.0;
}

bool isSafe(const ReportedTemperatures& temperatures, const StreamSettings& settings) {
  return settings.keep_heaters_on || heatsNothing(temperatures);
}

std::vector<std::string> reportsOn(const MarlinFirmware& firmware, const StreamSettings& settings) {
  std::vector<std::string> requests;
  if (settings.position_interval_s > 0)
    requests.push_back(firmware.reportPosition(settings.position_interval_s));
  if (settings.temperature_interval_s > 0)
    requests.push_back(firmware.reportTemperatures(settings.temperature_interval_s));
  return requests;
}

std::vector<std::string> reportsOff(const MarlinFirmware& firmware, const StreamSettings& settings) {
  std::vector<std::string> requests;
  if (settings.temperature_interval_s > 0) requests.push_back(firmware.reportTemperatures(0));
  if (settings.position_interval_s > 0) requests.push_back(firmware.reportPosition(0));
  return requests;
}

const char* unconfirmedStop(bool is_halted) {
  return is_halted
             ? "; a halted machine does not confirm the safe stop: see that it cools, and reset it"
             : "; the machine did not confirm the safe stop: it may still move and be hot, look after it";
}

}  // namespace lamina
