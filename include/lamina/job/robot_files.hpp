// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/job/output_writer.hpp"
#include "lamina/program/robot/robot_program_settings.hpp"

namespace lamina {

/// What runs a program, by the suffix of its file.
enum class ProgramRunner : std::uint8_t {
  Machine,     ///< .gcode, and what is no program at all
  RapidRobot,  ///< .mod
  OtherRobot,  ///< .src and further languages (`RobotLanguage`)
};
ProgramRunner programRunner(const std::string& path);

/// Whether a robot runs the program: RAPID and the languages besides.
bool isRobotFile(const std::string& path);

/// The language's name, for people: "RAPID", "KRL".
/// @param path  of a robot's program
std::string robotLanguageName(const std::string& path);

/// Writes a program of one file in a language besides RAPID.
/// @throws InvalidInput as `robotProgram`; also if no joints are known, or the program would speak other axes
///   than those of the bed; InvalidConfig if it takes several files
void writeRobotProgram(RobotLanguage language, const PlacedToolpath& placed,
                       const RobotProgramSettings& settings, const TextSink& sink);

/// Writes the file that is loaded first under the path, and those that it runs beside it; all files or none.
/// @throws InvalidInput, InvalidConfig as above; FileError
void writeRobotFiles(const std::string& path, const PlacedToolpath& placed,
                     const RobotProgramSettings& settings);

}  // namespace lamina
