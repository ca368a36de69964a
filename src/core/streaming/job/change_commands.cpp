// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/change_commands.hpp"

#include <cstddef>
#include <vector>

namespace lamina {
namespace {

/// A machine that prints must not be kept waiting by the program's disk: names are known beforehand.
ChangeCommand cancelByName(const StreamableProgram& program, std::size_t index) {
  const std::vector<std::string>& names = program.definedParts();
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
