// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/upload/duet_model.hpp"

#include <algorithm>
#include <optional>
#include <sstream>

#include "streaming/job/complaints.hpp"
#include "streaming/upload/server_answers.hpp"

namespace lamina {
namespace {

using nlohmann::json;

const json& listAt(const json& tree, const char* path) {
  static const json kNone = json::array();
  const json::json_pointer pointer(path);
  return tree.contains(pointer) && tree.at(pointer).is_array() ? tree.at(pointer) : kNone;
}

PrintState underWay(const std::string& status) {
  if (status == "paused") return PrintState::Paused;
  if (status == "pausing" || status == "resuming" || status == "cancelling") return PrintState::Changing;
  return PrintState::Printing;
}

/// How the last print ended. The board itself keeps no more of it than its duration, which is 0 unless it ran
/// to its end.
PrintState ended(const json& model) {
  if (model.contains(json::json_pointer("/job/lastFileCancelled"))) {
    if (valueAt(model, "/job/lastFileAborted", false)) return PrintState::Failed;
    const bool is_printed =
        !valueAt(model, "/job/lastFileCancelled", true) && !valueAt(model, "/job/lastFileSimulated", false);
    return is_printed ? PrintState::Complete : PrintState::Stopped;
  }
  return valueAt(model, "/job/lastDuration", 0.0) > 0.0 ? PrintState::Complete : PrintState::Stopped;
}

bool isOn(const json& heater) {
  const std::string state = valueAt<std::string>(heater, "/state", "active");
  if (state == "off" || state == "fault") return false;
  // Without heat it is as good as off.
  const char* target = state == "standby" ? "/standby" : "/active";
  return state == "tuning" || valueAt(heater, target, 1.0) > 0.0;
}

double targetOf(const json& heater) {
  const std::string state = valueAt<std::string>(heater, "/state", "off");
  if (state == "active") return valueAt(heater, "/active", 0.0);
  return state == "standby" ? valueAt(heater, "/standby", 0.0) : 0.0;
}

std::optional<std::size_t> bedHeater(const json& model) {
  for (const json& number : listAt(model, "/heat/bedHeaters"))
    if (number.is_number_integer() && number.get<int>() >= 0) return number.get<std::size_t>();
  return std::nullopt;
}

bool heatsNoTool(const json& model, std::size_t heater) {
  for (const char* others : {"/heat/bedHeaters", "/heat/chamberHeaters"})
    for (const json& number : listAt(model, others))
      if (number == heater) return true;
  return false;
}

std::optional<ReportedTemperatures> temperaturesOf(const json& model) {
  const json& heaters = listAt(model, "/heat/heaters");
  std::size_t nozzle = 0;
  while (nozzle < heaters.size() && (!heaters[nozzle].is_object() || heatsNoTool(model, nozzle))) ++nozzle;
  if (nozzle >= heaters.size()) return std::nullopt;
  ReportedTemperatures temperatures;
  temperatures.nozzle_c = valueAt(heaters[nozzle], "/current", 0.0);
  temperatures.nozzle_target_c = targetOf(heaters[nozzle]);
  const auto bed = bedHeater(model);
  if (!bed || *bed >= heaters.size() || !heaters[*bed].is_object()) return temperatures;
  temperatures.bed_c = valueAt(heaters[*bed], "/current", 0.0);
  temperatures.bed_target_c = targetOf(heaters[*bed]);
  return temperatures;
}

std::optional<ReportedPosition> positionOf(const json& model) {
  const json& axes = listAt(model, "/move/axes");
  if (axes.size() < 3) return std::nullopt;
  return ReportedPosition{valueAt(axes[0], "/userPosition", 0.0), valueAt(axes[1], "/userPosition", 0.0),
                          valueAt(axes[2], "/userPosition", 0.0),
                          valueAt(model, "/move/extruders/0/position", 0.0)};
}

}  // namespace

std::string belowPrograms(const std::string& name) {
  std::string file = name.compare(0, 2, "0:") == 0 ? name.substr(2) : name;
  file.erase(0, file.find_first_not_of('/'));
  constexpr std::string_view kPrograms = "gcodes/";
  return file.compare(0, kPrograms.size(), kPrograms) == 0 ? file.substr(kPrograms.size()) : file;
}

MachineReport reportOf(const json& model) {
  MachineReport report;
  const std::string status = valueAt<std::string>(model, "/state/status", "disconnected");
  report.is_halted = status == "halted" || status == "off";
  report.is_ready =
      !report.is_halted && status != "starting" && status != "updating" && status != "disconnected";
  report.condition = "its status is " + status;
  const std::string printed = valueAt<std::string>(model, "/job/file/fileName", "");
  const std::string last = valueAt<std::string>(model, "/job/lastFileName", "");
  if (!printed.empty()) {
    report.file = belowPrograms(printed);
    report.state = underWay(status);
    report.bytes_read = valueAt<std::uint64_t>(model, "/job/filePosition", 0);
  } else if (!last.empty()) {
    report.file = belowPrograms(last);
    report.state = ended(model);
  }
  const json& heaters = listAt(model, "/heat/heaters");
  report.has_targets = std::any_of(heaters.begin(), heaters.end(),
                                   [](const json& heater) { return heater.is_object() && isOn(heater); });
  report.temperatures = temperaturesOf(model);
  report.position = positionOf(model);
  return report;
}

std::vector<std::string> complaintsIn(const std::string& said) {
  std::vector<std::string> complaints;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);)
    if (reprapComplaint(line) != Complaint::None) complaints.push_back(line);
  return complaints;
}

std::string heatersOffCommands(const json& tools) {
  std::string commands = "M140 S-273.15\nM141 S-273.15";
  for (const json& tool : tools)
    if (tool.is_object()) commands += "\nM568 P" + std::to_string(valueAt(tool, "/number", 0)) + " A0";
  return commands + "\nM107";
}

/// Waiting for heat is ended first, since the board hears nothing else meanwhile.
std::string cancelCommand(PrintState state) { return state == PrintState::Paused ? "M0" : "M108\nM25"; }

}  // namespace lamina
