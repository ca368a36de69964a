// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "startup/startup_code.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "lamina/base/exact_text.hpp"
#include "lamina/base/text.hpp"
#include "program/gcode/command_words.hpp"

namespace lamina {

std::string filled(std::string text, std::string_view place, const std::string& by) {
  for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at + by.size()))
    text.replace(at, place.size(), by);
  return text;
}

std::string shortNumber(double value) { return exactText(std::round(value * 1e3) / 1e3); }

std::string dwell(double seconds) {
  constexpr double kLongest = 5.0;  // s
  std::string code;
  for (double left = seconds; left > 1e-3; left -= kLongest)
    code += "G4 P" + std::to_string(std::lround(1e3 * std::min(left, kLongest))) + "\n";
  return code;
}

std::string bedRamp(const StartupSettings& settings, double from_c) {
  const auto setTo = [&](double target_c) {
    return filled(settings.bed_code, "{target_c}", shortNumber(target_c)) + "\n";
  };
  std::string code;
  const double step_s = 60.0 / settings.bed_rate_c_min;
  for (double target_c = std::floor(from_c) + 1.0; target_c < settings.bed_target_c; target_c += 1.0)
    code += setTo(target_c) + dwell(step_s);
  return code + setTo(settings.bed_target_c);
}

std::string vacuumOn(const StartupSettings& settings) {
  std::string code;
  for (const int zone : vacuumZones(settings))
    code += filled(settings.vacuum_on_code, "{zone}", std::to_string(zone)) + "\n";
  return code;
}

std::vector<std::string> vacuumOffCommands(const StartupSettings& settings) {
  std::vector<std::string> commands;
  for (const int zone : vacuumZones(settings)) {
    std::istringstream lines(filled(settings.vacuum_off_code, "{zone}", std::to_string(zone)));
    for (std::string line; std::getline(lines, line);)
      if (!trimmed(line).empty()) commands.emplace_back(trimmed(line));
  }
  return commands;
}

std::string codeOf(const std::string& command) {
  const bool is_code = command.size() > 1 && command[1] >= '0' && command[1] <= '9';
  return command.substr(0, is_code ? command.find_first_not_of("0123456789.", 1) : command.find(' '));
}

std::optional<double> bedTargetIn(const std::string& command) {
  const auto target_c = wordValue(command, 'S');
  return target_c ? target_c : wordValue(command, 'R');
}

std::string axesOf(const std::string& command) {
  const std::string words = command.size() > 3 ? command.substr(3) : "";
  std::string axes;
  for (const char axis : {'X', 'Y', 'Z'})
    if (words.find(axis) != std::string::npos) axes += axis;
  if (!axes.empty()) return axes;
  return words.find('E') == std::string::npos ? "XYZ" : "";
}

bool asksForHoming(const std::string& text) {
  if (text.find("insufficient axes homed") != std::string::npos) return true;
  return text.compare(0, 10, "echo:Home ") == 0 && text.find("irst") != std::string::npos;
}

bool isDoneByHand(StartupStep step, const StartupSettings& settings) {
  switch (step) {
    case StartupStep::DryPellets:
      return settings.dry_code.empty();
    case StartupStep::HeatBed:
      return settings.bed_code.empty();
    case StartupStep::HomeX:
    case StartupStep::HomeY:
    case StartupStep::HomeZ:
    case StartupStep::HomeZAgain:
      return settings.home_code.empty();
    case StartupStep::DrawVacuum:
      return settings.vacuum_on_code.empty();
    case StartupStep::MapHeights:
      return false;
    default:
      return true;
  }
}

bool isReported(StartupStep step, const StartupSettings& settings) {
  switch (step) {
    case StartupStep::DryPellets:
      return !settings.dry_label.empty();
    case StartupStep::HeatBed:
    case StartupStep::MapHeights:
      return true;
    case StartupStep::DrawVacuum:
      return !settings.vacuum_label.empty();
    default:
      return homedAxis(step) && !settings.home_label.empty();
  }
}

}  // namespace lamina
