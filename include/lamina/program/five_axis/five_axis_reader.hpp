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

/// Whether a program has the header that `writeFiveAxis` writes.
bool isFiveAxisProgram(std::string_view program);

/// Reads a program that `writeFiveAxis` wrote for this machine, into coordinates of the bed. Poses come from
/// the machine's forward kinematics, everything else as in `toolpathFromGcode`. Start and end code are left
/// out. A line that ends in `;via` lies between two waypoints and adds no waypoint. A line that ends in
/// `;turn` rotates the tool in place and adds no motion. A line that ends in `;close` returns to the start of
/// its path.
///
/// @throws InvalidProgram naming the line, what was found and what was expected: for axes that the machine
///   does not have, unknown instructions, an axis without a value yet, a feed that is missing or not
///   positive, and a program without motion
Toolpath readFiveAxis(std::string_view program, const KinematicModel& machine,
                      const FiveAxisSettings& settings, const ProgramSettings& filament,
                      const std::string& part_name);

/// Reads a program as `readFiveAxis` does, and also returns the joint values of the machine at each line that
/// moves; here `;via` lines add waypoints, too, and successive `;turn` lines add a travel whose waypoints all
/// lie at the tip. Rotary joints have the values in the program. Linear joints also have the values in the
/// program or, in a program of tip positions, the values to which tip control moves them. Limits and
/// collisions are not checked: there are no faults.
/// @throws InvalidProgram as above
StatedMotion readFiveAxisMotion(std::string_view program, const KinematicModel& machine,
                                const FiveAxisSettings& settings, const ProgramSettings& filament,
                                const std::string& part_name);

}  // namespace lamina
