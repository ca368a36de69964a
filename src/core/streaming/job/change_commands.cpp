// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/change_commands.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::string_view kDefinition = "EXCLUDE_OBJECT_DEFINE ";
constexpr std::string_view kBeginning = "EXCLUDE_OBJECT_START ";
constexpr std::string_view kNameKey = "NAME=";

/// The names of the parts that a program defines, in its order: those in front of the first part that begins.
std::vector<std::string> definedParts(const StreamableProgram& program) {
  constexpr int kMostLines = 100000;  // a job waits meanwhile, for some hundredths of a second
  std::vector<std::string> names;
  ProgramCursor cursor = program.open();
  for (int i = 0; i < kMostLines; ++i) {
    const auto line = cursor.next();
    if (!line || line->command.compare(0, kBeginning.size(), kBeginning) == 0) break;
    if (line->command.compare(0, kDefinition.size(), kDefinition) != 0) continue;
    const std::size_t name = line->command.find(kNameKey);
    if (name == std::string::npos) continue;
    const std::size_t first = name + kNameKey.size();
    names.push_back(line->command.substr(first, line->command.find(' ', first) - first));
  }
  return names;
}

ChangeCommand cancelByName(const StreamableProgram& program, std::size_t index) {
  std::vector<std::string> names;
  try {
    names = definedParts(program);
  } catch (const Error& error) {
    return {"", error.what()};
  }
  if (index < names.size()) return {"EXCLUDE_OBJECT NAME=" + names[index], ""};
  return {"", "part " + std::to_string(index) + " is not in the program, which defines " +
                  std::to_string(names.size()) + " for Klipper (EXCLUDE_OBJECT_DEFINE)"};
}

}  // namespace

ChangeCommand klipperChange(const LiveChange& change, const StreamableProgram& program) {
  if (change.setting == LiveSetting::CancelPart)
    return cancelByName(program, static_cast<std::size_t>(change.value));
  if (change.setting == LiveSetting::Babystep)
    return {"SET_GCODE_OFFSET Z_ADJUST=" + decimal(change.value) + " MOVE=1", ""};
  if (const auto command = overrideCommand(change)) return {*command, ""};
  return {"", notOf("Klipper", change.setting)};
}

ChangeCommand reprapChange(const LiveChange& change) {
  if (change.setting == LiveSetting::Babystep) return {"M290 R1 S" + decimal(change.value), ""};
  if (const auto command = overrideCommand(change)) return {*command, ""};
  if (const auto command = cancelCommand(change)) return {*command, ""};
  return {"", notOf("RepRapFirmware", change.setting)};
}

}  // namespace lamina
