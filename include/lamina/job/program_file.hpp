// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/program/stated_motion.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Whether the suffix is that of G-code: .gcode, in capitals too.
bool isGcodeFile(const std::string& path);

/// Whether the suffix is that of a program: .gcode, or that of a robot's language.
bool isProgramFile(const std::string& path);

/// Reads a program of any kind: one of a robot, G-code of linear axes, or five-axis G-code, which is read
/// through the machine's joints. The toolpath is in coordinates of the bed and named after the file.
/// @throws FileError if it cannot be read
/// @throws InvalidProgram naming the line, as `readRapidFile`, `readRobotProgramFile`,
///   `toolpathFromGcodeFile`, `readFiveAxis`; also if five-axis G-code is for other axes than the machine's
Toolpath readProgram(const std::string& path, const ProgramSettings& settings,
                     const MachineSettings& machine);

/// The joint values that a program states, line by line: five-axis G-code has the rotary ones in its words;
/// RAPID has configurations and external axes in its targets (`readRapidMotion`); programs in other robot
/// languages state the joints with which they begin (`readRobotMotion`). Nothing for G-code of linear axes,
/// for toolpaths, and for programs of robots if the model is no six-axis arm.
/// @throws as `readProgram`
std::optional<StatedMotion> readStatedMotion(const std::string& path, const ProgramSettings& settings,
                                             const KinematicModel& model);

/// Offsets of tools' nozzles that the head of a program in G-code states (`;TOOL_OFFSET:`), by tool, along
/// the axes of the program; none for other programs.
/// @throws FileError; InvalidProgram if a comment states no offset
std::vector<Point3> toolOffsetsIn(const std::string& path);

/// Whether the suffix is that of a toolpath: .csv, in capitals too.
bool isToolpathFile(const std::string& path);

/// Reads a program as `readProgram`, or the CSV of a toolpath as `readCsv`.
/// @throws InvalidInput if the suffix is that of neither
/// @throws as these two functions
Toolpath readToolpathFile(const std::string& path, const ProgramSettings& settings,
                          const MachineSettings& machine);

}  // namespace lamina
