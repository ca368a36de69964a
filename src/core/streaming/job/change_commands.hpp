// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/streaming/job/live_change.hpp"
#include "lamina/streaming/job/streamable_program.hpp"
#include "streaming/job/decimal.hpp"

namespace lamina {

/// The command for a change of feed or flow, which is the same for Marlin, RepRapFirmware and Klipper;
/// nothing for other changes.
inline std::optional<std::string> overrideCommand(const LiveChange& change) {
  if (change.setting == LiveSetting::Feed) return "M220 S" + decimal(change.value);
  if (change.setting == LiveSetting::Flow) return "M221 S" + decimal(change.value);
  return std::nullopt;
}

/// The command by which Marlin and RepRapFirmware leave out a part, by its index; nothing for other changes.
inline std::optional<std::string> cancelCommand(const LiveChange& change) {
  if (change.setting == LiveSetting::CancelPart) return "M486 P" + decimal(change.value);
  return std::nullopt;
}

/// Message on a command that was not answered.
inline std::string noAnswerTo(const std::string& command) {
  return "no answer to " + command + ", which may not have been done";
}

/// The command for a change, or why it is refused: one of the two is empty.
struct ChangeCommand {
  std::string command;
  std::string refusal;
};

/// Command of Klipper for a change. Klipper leaves out a part by the name that the program defines
/// (`EXCLUDE_OBJECT_DEFINE`); the index of a part counts these definitions from 0.
ChangeCommand klipperChange(const LiveChange& change, const StreamableProgram& program);

/// Command of RepRapFirmware for a change.
ChangeCommand reprapChange(const LiveChange& change);

}  // namespace lamina
