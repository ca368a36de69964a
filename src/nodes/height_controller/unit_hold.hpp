// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/cell/packml_model.hpp"
#include "lamina/cell/unit_machine.hpp"
#include "print_hold.hpp"

namespace lamina {

/// Whether a unit in that state deposits nothing until it is commanded: all states except Starting, Execute,
/// Unholding, Suspending, Suspended and Unsuspending. A suspended unit continues by itself.
bool isAtBay(UnitState state);

/// The outcome of a Hold command to a unit.
/// @param result   of the command
/// @param message  why it is refused; empty if it is not
/// @param state    state of the unit after the command; none if it is not known
PrintHold::Answer answerToHold(CommandResult result, const std::string& message,
                               std::optional<UnitState> state);

}  // namespace lamina
