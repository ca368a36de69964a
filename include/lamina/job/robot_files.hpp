// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/job/output_writer.hpp"
#include "lamina/program/robot/robot_program_settings.hpp"
#include "lamina/program/robot/speed_rounding.hpp"

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

/// Files of a program that was written.
struct RobotWriting {
  std::vector<std::string> files;  ///< names, the one that is loaded first before those that it runs
  SpeedRounding speeds;
};

/// Files beside a program whose numbers go on from its own, as a longer program of that name left them.
/// @param path  of the file that is loaded first
/// @param names  of all files of the program
/// @return names in the order of their numbers
std::vector<std::string> filesOfLongerProgram(const std::string& path, const std::vector<std::string>& names);

/// Writes the file that is loaded first under the path, and those that it runs beside it; all files or none.
/// @throws InvalidInput, InvalidConfig as above; FileError
RobotWriting writeRobotFiles(const std::string& path, const PlacedToolpath& placed,
                             const RobotProgramSettings& settings);

/// The same of a toolpath over the bed whose joints are not known, without approach and retract.
/// @throws InvalidInput also if the language is URScript, whose poses are over the robot's base
RobotWriting writeRobotFiles(const std::string& path, const Toolpath& over_bed,
                             const RobotProgramSettings& settings);

}  // namespace lamina
