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

/// Whether the header is that of a program that `writeFiveAxis` wrote.
bool isFiveAxisProgram(std::string_view program);

/// Reads a program that `writeFiveAxis` wrote for the machine, in coordinates of the bed: poses come from the
/// machine's forward kinematics, everything else as in `toolpathFromGcode`. Start and end code are left out.
/// A line that ends in `;via` lies between two waypoints and gives none; one that ends in `;turn` rotates the
/// tool in place and gives no motion; one that ends in `;close` returns to where its path began.
///
/// @throws InvalidProgram naming the line, what was found and what was expected: axes that are not those of
///   the machine, instructions that are not known, an axis that has no value yet, a feed that is missing or
///   not positive; also if nothing in it moves
Toolpath readFiveAxis(std::string_view program, const KinematicModel& machine,
                      const FiveAxisSettings& settings, const ProgramSettings& filament,
                      const std::string& part_name);

/// Reads a program likewise, and also returns the joints of the machine at each line that moves; `;via` lines
/// give waypoints, too, and `;turn` lines in succession give a travel whose waypoints all lie at the tip.
/// Rotary joints are as written. Linear joints are as written, or, in a program of tip positions, where tip
/// control moves them for the rotary joints as written. Limits and collisions are not checked: there are no
/// faults.
/// @throws InvalidProgram as above
StatedMotion readFiveAxisMotion(std::string_view program, const KinematicModel& machine,
                                const FiveAxisSettings& settings, const ProgramSettings& filament,
                                const std::string& part_name);

}  // namespace lamina
