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
    if (const auto heater = numberOf<std::size_t>(number)) return heater;
  return std::nullopt;
}

bool heatsNoTool(const json& model, std::size_t heater) {
  for (const char* others : {"/heat/bedHeaters", "/heat/chamberHeaters"})
    for (const json& number : listAt(model, others))
      if (number == heater) return true;
  return false;
}

std::string currentOf(std::size_t heater) { return "/heat/heaters/" + std::to_string(heater) + "/current"; }

std::optional<ReportedTemperatures> temperaturesOf(const json& model, AnswerNumbers& numbers) {
  const json& heaters = listAt(model, "/heat/heaters");
  std::size_t nozzle = 0;
  while (nozzle < heaters.size() && (!heaters[nozzle].is_object() || heatsNoTool(model, nozzle))) ++nozzle;
  if (nozzle >= heaters.size()) return std::nullopt;
  const auto nozzle_c = numbers.at<double>(currentOf(nozzle));
  if (!nozzle_c) return std::nullopt;
  ReportedTemperatures temperatures;
  temperatures.nozzle_c = *nozzle_c;
  temperatures.nozzle_target_c = targetOf(heaters[nozzle]);
  const auto bed = bedHeater(model);
  if (!bed || *bed >= heaters.size() || !heaters[*bed].is_object()) return temperatures;
  temperatures.bed_c = numbers.at<double>(currentOf(*bed));
  if (temperatures.bed_c) temperatures.bed_target_c = targetOf(heaters[*bed]);
  return temperatures;
}

std::optional<ReportedPosition> positionOf(AnswerNumbers& numbers) {
  const auto x = numbers.at<double>("/move/axes/0/userPosition");
  const auto y = numbers.at<double>("/move/axes/1/userPosition");
  const auto z = numbers.at<double>("/move/axes/2/userPosition");
  if (!x || !y || !z) return std::nullopt;
  return ReportedPosition{*x, *y, *z, numbers.at<double>("/move/extruders/0/position").value_or(0.0)};
}

/// Whether a heater has a target, or may have one: what cannot be read may.
bool mayHeat(const json& model, AnswerNumbers& numbers) {
  constexpr const char* kHeaters = "/heat/heaters";
  const json::json_pointer listed(kHeaters);
  if (model.contains(listed) && !model.at(listed).is_array() && !model.at(listed).is_null()) {
    numbers.doubt(kHeaters, "a list");
    return true;
  }
  const json& heaters = listAt(model, kHeaters);
  return std::any_of(heaters.begin(), heaters.end(),
                     [](const json& heater) { return heater.is_object() && isOn(heater); });
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
  AnswerNumbers numbers(model);
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
    report.bytes_read = numbers.at<std::uint64_t>("/job/filePosition");
  } else if (!last.empty()) {
    report.file = belowPrograms(last);
    report.state = ended(model);
  }
  report.has_targets = mayHeat(model, numbers);
  report.temperatures = temperaturesOf(model, numbers);
  report.position = positionOf(numbers);
  report.doubt = numbers.doubted();
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
  // Tools are listed by their numbers: one that does not state its own stands in its place.
  for (std::size_t i = 0; i < tools.size(); ++i)
    if (tools[i].is_object())
      commands +=
          "\nM568 P" + std::to_string(valueAt(tools[i], "/number", static_cast<std::uint32_t>(i))) + " A0";
  return commands + "\nM107";
}

/// Waiting for heat is ended first, since the board hears nothing else meanwhile.
std::string cancelCommand(PrintState state) { return state == PrintState::Paused ? "M0" : "M108\nM25"; }

}  // namespace lamina
