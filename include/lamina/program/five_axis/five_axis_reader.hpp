// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/five_axis/five_axis_settings.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/program/stated_motion.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Whether the text's header states five axes.
bool isFiveAxisProgram(std::string_view program);

/// Reads a program that `writeFiveAxis` wrote for the machine, in coordinates of the bed: poses come from the
/// machine's forward kinematics, everything else as in `toolpathFromGcode`. What stands before the part and
/// after it, start and end code, is left out. Lines that end in `;via` are no waypoints, those that end in
/// `;turn` no motions; one that ends in `;close` returns to where its path began.
///
/// @throws InvalidProgram naming the line, what was found and what was expected: axes that are not those of
///   the machine, instructions that are not known, an axis that has no value yet, a feed that is missing or
///   not positive; also if nothing in it moves
Toolpath readFiveAxis(std::string_view program, const KinematicModel& machine,
                      const FiveAxisSettings& settings, const ProgramSettings& filament,
                      const std::string& part_name);

/// The same with the machine's joints as every line states them, those in `;via` lines too: rotary joints are
/// the words themselves; linear ones are the words, or where tip control moves them with the rotary joints as
/// written. Nothing is judged, and there are no faults.
/// @throws InvalidProgram as above
StatedMotion readFiveAxisMotion(std::string_view program, const KinematicModel& machine,
                                const FiveAxisSettings& settings, const ProgramSettings& filament,
                                const std::string& part_name);

}  // namespace lamina
