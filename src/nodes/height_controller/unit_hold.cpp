// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "unit_hold.hpp"

namespace lamina {

bool isAtBay(UnitState state) {
  switch (state) {
    case UnitState::Starting:
    case UnitState::Execute:
    case UnitState::Unholding:
    case UnitState::Suspending:
    case UnitState::Suspended:
    case UnitState::Unsuspending:
      return false;
    default:
      return true;
  }
}

PrintHold::Answer answerToHold(CommandResult result, const std::string& message,
                               std::optional<UnitState> state) {
  if (message.empty()) return {true, "the unit holds the print"};
  // Mostly since it holds already, by the alarm that was reported to it.
  const bool is_passing = result == CommandResult::NotInThisState && !(state && isAtBay(*state));
  if (result == CommandResult::NotInThisState && !is_passing)
    return {true, "the unit takes no Hold: " + message};
  return {false, "the print is not held: " + message, is_passing};
}

}  // namespace lamina
