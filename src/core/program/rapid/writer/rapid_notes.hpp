// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/toolpath/toolpath.hpp"
#include "program/rapid/writer/rapid_plan.hpp"

namespace lamina {

/// Beginning of a comment that states what the moves of a program do not: `!# path outer_wall closed 12`.
constexpr std::string_view kRapidNote = "!# ";

/// The notes, without `kRapidNote`, of procedures that lead to the part and away from it.
constexpr std::string_view kRapidApproach = "approach";
constexpr std::string_view kRapidRetract = "retract";

/// Beginning of the note at a program's head that states how long before the end of a run its wire stops [s].
constexpr std::string_view kRapidWireStop = "wire_stop";

/// Appends the comments before a procedure. For each of its paths they state the layer if a new one begins,
/// the role, whether the path is closed, retracted or begins with a move of its own, the number of its moves
/// in this procedure, and runs of motions with one bead.
/// @param rise_mm  rise of the part's origin along the layers' normal
void appendRapidNotes(const Toolpath& toolpath, const RapidPlan& plan, const RapidChunk& chunk,
                      double rise_mm, std::string& text);

}  // namespace lamina
