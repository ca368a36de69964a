// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/cell/packml_model.hpp"
#include "lamina/cell/unit_machine.hpp"
#include "print_hold.hpp"

namespace lamina {

/// Whether a unit in that state deposits nothing until somebody commands it: Held, stopped, aborted, at its
/// end or on the way there. One that is suspended goes on by itself, and one that goes on deposits.
bool isAtBay(UnitState state);

/// What became of a Hold that was asked of a unit.
/// @param result   of the command
/// @param message  why it is refused; empty if it is not
/// @param state    of the unit after that; none if it is not known
PrintHold::Answer answerToHold(CommandResult result, const std::string& message,
                               std::optional<UnitState> state);

}  // namespace lamina
