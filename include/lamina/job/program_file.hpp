// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/kinematics/cartesian/cartesian_machine_settings.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/program/stated_motion.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Whether the suffix is that of G-code: .gcode.
bool isGcodeFile(const std::string& path);

/// Whether the suffix is that of a program: .gcode, or that of a robot's language.
bool isProgramFile(const std::string& path);

/// Reads a program of any kind, in coordinates of the bed: those of robots, G-code of linear axes, and
/// five-axis G-code through the joints of the machine. The toolpath is named after the file.
/// @throws FileError if it cannot be read
/// @throws InvalidProgram naming the line, as `readRapidFile`, `readRobotProgramFile`,
/// `toolpathFromGcodeFile`, `readFiveAxis`; of
///   five axes also if the machine has others
Toolpath readProgram(const std::string& path, const ProgramSettings& settings,
                     const MachineSettings& machine);

/// The joints that a program holds, line by line: five-axis G-code has the rotary ones in its words, RAPID
/// configurations and external axes in its targets (`readRapidMotion`), other languages of robots the joints
/// they start from
/// (`readRobotMotion`). Nothing for programs that hold none:
/// G-code of linear axes, programs of robots on a machine that is no arm, toolpaths.
/// @throws as `readProgram`
std::optional<StatedMotion> readStatedMotion(const std::string& path, const ProgramSettings& settings,
                                             const KinematicModel& model);

/// Whether the suffix is that of a toolpath: .csv.
bool isToolpathFile(const std::string& path);

/// Reads a program as `readProgram`, or the CSV of a toolpath (`readCsv`).
/// @throws InvalidInput if the suffix is that of neither
/// @throws as those
Toolpath readToolpathFile(const std::string& path, const ProgramSettings& settings,
                          const MachineSettings& machine);

}  // namespace lamina
