// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/streaming/job/live_change.hpp"
#include "lamina/streaming/job/streamable_program.hpp"
#include "streaming/job/decimal.hpp"

namespace lamina {

/// The command of a change that Marlin, RepRapFirmware and Klipper have in common, that of feed or flow;
/// nothing for any other.
inline std::optional<std::string> overrideCommand(const LiveChange& change) {
  if (change.setting == LiveSetting::Feed) return "M220 S" + decimal(change.value);
  if (change.setting == LiveSetting::Flow) return "M221 S" + decimal(change.value);
  return std::nullopt;
}

/// That by which Marlin and RepRapFirmware leave out a part by its index; nothing for any other change.
inline std::optional<std::string> cancelCommand(const LiveChange& change) {
  if (change.setting == LiveSetting::CancelPart) return "M486 P" + decimal(change.value);
  return std::nullopt;
}

/// By which command a change is made, or why it is refused: one of the two is empty.
struct ChangeCommand {
  std::string command;
  std::string refusal;
};

/// Klipper's. A part is left out by the name under which the program defines it (`EXCLUDE_OBJECT_DEFINE`),
/// counted from 0.
ChangeCommand klipperChange(const LiveChange& change, const StreamableProgram& program);

/// RepRapFirmware's.
ChangeCommand reprapChange(const LiveChange& change);

}  // namespace lamina
