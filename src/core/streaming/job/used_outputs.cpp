// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/used_outputs.hpp"

#include <cctype>
#include <charconv>
#include <optional>

#include "program/gcode/command_words.hpp"

namespace lamina {
namespace {

/// The number of a command such as "M104 S200"; nothing if it begins with another letter.
std::optional<int> numberOf(std::string_view command, char letter) {
  if (command.empty() || command.front() != letter) return std::nullopt;
  int number = 0;
  const auto read = std::from_chars(command.data() + 1, command.data() + command.size(), number);
  if (read.ec != std::errc()) return std::nullopt;
  return number;
}

int indexOf(std::string_view command, char letter, int otherwise) {
  return static_cast<int>(wordValue(command, letter).value_or(otherwise));
}

}  // namespace

void UsedOutputs::see(std::string_view command) {
  if (const auto tool = numberOf(command, 'T')) {
    tool_ = *tool;
    names_tools_ = true;
  }
  const auto code = numberOf(command, 'M');
  if (!code) return;
  switch (*code) {
    case 3:
    case 4:
      has_beam_ = true;
      break;
    case 7:
    case 8:
      has_coolant_ = true;
      break;
    case 104:
    case 109:
      names_tools_ = names_tools_ || wordValue(command, 'T');
      heated_tools_.insert(indexOf(command, 'T', tool_));
      break;
    case 106:
      fans_.insert(indexOf(command, 'P', 0));
      break;
    case 141:
    case 191:
      has_chamber_ = true;
      break;
    case 143:
    case 193:
      has_laser_cooler_ = true;
      break;
    default:
      break;
  }
}

std::vector<std::string> UsedOutputs::beamOff() const {
  return has_beam_ ? std::vector<std::string>{"M5"} : std::vector<std::string>{};
}

std::vector<std::string> UsedOutputs::heatOff() const {
  std::vector<std::string> commands;
  // Also the tool that should be active: its T command may have been lost or refused, and the machine may
  // have begun with another one. A program that names no tool heats the active one, whichever that is.
  if (names_tools_)
    for (const int tool : heated_tools_) commands.push_back("M104 T" + std::to_string(tool) + " S0");
  if (has_chamber_) commands.emplace_back("M141 S0");
  if (has_laser_cooler_) commands.emplace_back("M143 S0");
  return commands;
}

std::vector<std::string> UsedOutputs::airOff() const {
  std::vector<std::string> commands;
  for (const int fan : fans_) commands.push_back(fan == 0 ? "M107" : "M106 P" + std::to_string(fan) + " S0");
  if (has_coolant_) commands.emplace_back("M9");
  return commands;
}

}  // namespace lamina
