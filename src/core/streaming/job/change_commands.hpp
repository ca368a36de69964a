// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/streaming/job/live_change.hpp"
#include "lamina/streaming/job/streamable_program.hpp"
#include "streaming/job/decimal.hpp"

namespace lamina {

/// The command for a change of feed or flow, which Marlin, RepRapFirmware and Klipper have in common; none
/// for any other change.
inline std::optional<std::string> overrideCommand(const LiveChange& change) {
  if (change.setting == LiveSetting::Feed) return "M220 S" + decimal(change.value);
  if (change.setting == LiveSetting::Flow) return "M221 S" + decimal(change.value);
  return std::nullopt;
}

/// The command by which Marlin and RepRapFirmware leave out a part by its index; none for any other change.
inline std::optional<std::string> cancelCommand(const LiveChange& change) {
  if (change.setting == LiveSetting::CancelPart) return "M486 P" + decimal(change.value);
  return std::nullopt;
}

/// The message on a command whose answer did not come.
inline std::string noAnswerTo(const std::string& command) {
  return "no answer to " + command + ", which may not have been done";
}

/// The command for a change, or why it is refused: one of the two is empty.
struct ChangeCommand {
  std::string command;
  std::string refusal;
};

/// That of Klipper, which leaves out a part by the name that the program defines (`EXCLUDE_OBJECT_DEFINE`);
/// its index counts these definitions from 0.
ChangeCommand klipperChange(const LiveChange& change, const StreamableProgram& program);

/// That of RepRapFirmware.
ChangeCommand reprapChange(const LiveChange& change);

}  // namespace lamina
