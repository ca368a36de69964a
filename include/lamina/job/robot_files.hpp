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

/// The kind of device that runs a program, by the suffix of its file.
enum class ProgramRunner : std::uint8_t {
  Machine,     ///< .gcode, and every suffix that is not a robot's
  RapidRobot,  ///< .mod
  OtherRobot,  ///< .src and those of further languages (`RobotLanguage`)
};
ProgramRunner programRunner(const std::string& path);

/// Whether the program is for a robot: in RAPID or in a `RobotLanguage`.
bool isRobotFile(const std::string& path);

/// Name of a robot program's language, as "RAPID" or "KRL".
/// @param path  path of a robot's program
std::string robotLanguageName(const std::string& path);

/// Writes a program that is a single file, in a language other than RAPID.
/// @throws InvalidInput as `robotProgram`; also if no joint values are given, or the machine's axes are not
///   at right angles
/// @throws InvalidConfig if the program needs several files
void writeRobotProgram(RobotLanguage language, const PlacedToolpath& placed,
                       const RobotProgramSettings& settings, const TextSink& sink);

/// What was written: the files of a program, how its speeds were rounded, and which outputs stay at 0.
struct RobotWriting {
  std::vector<std::string> files;  ///< names; the file to be loaded first, then the files that it calls
  SpeedRounding speeds;
  std::vector<RobotLevel> unstated;  ///< entries of robot_program.levels whose process value no path states
};

/// Names of files beside a program whose numbers follow those of its own files. They were left by a longer
/// program with the same name.
/// @param path   path of the file that is loaded first
/// @param names  names of all files of the program
/// @return names in the order of their numbers
std::vector<std::string> filesOfLongerProgram(const std::string& path, const std::vector<std::string>& names);

/// Writes the file that is loaded first at the path, and the files that it calls beside it; all files or
/// none.
/// @throws InvalidInput, InvalidConfig as above; FileError
RobotWriting writeRobotFiles(const std::string& path, const PlacedToolpath& placed,
                             const RobotProgramSettings& settings);

/// Writes a toolpath in coordinates of the bed whose joint values are not known, into one or more files as
/// above, but without approach and retract.
/// @throws as above; InvalidInput also if the language is URScript, whose poses are relative to the robot's
///   base
RobotWriting writeRobotFiles(const std::string& path, const Toolpath& over_bed,
                             const RobotProgramSettings& settings);

}  // namespace lamina
