// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/program_file.hpp"

#include <filesystem>
#include <fstream>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/base/text.hpp"
#include "lamina/job/robot_files.hpp"
#include "lamina/kinematics/arm/abb_configuration.hpp"
#include "lamina/program/csv/csv_reader.hpp"
#include "lamina/program/five_axis/five_axis_reader.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "lamina/program/rapid/reader/rapid_reader.hpp"
#include "lamina/program/robot/robot_reader.hpp"
#include "program/gcode/tool_offsets.hpp"

namespace lamina {
namespace {

/// The comments at the head of a program. They state whether it has five axes, so the rest, which may be
/// long, need not be read.
std::string headOf(const std::string& path) {
  constexpr std::size_t kMostHead = 1 << 16;
  std::string bytes(kMostHead, '\0');
  bytes.resize(InputFile(path).read(bytes.data(), bytes.size()));
  std::istringstream lines(std::string(utf8Text(bytes, path)));
  std::string head;
  // Of a Fanuc control's program also the mark, number or name, and comments in brackets.
  const auto isOfHead = [](const std::string& line) {
    return !line.empty() && std::string_view(";%O<(").find(line.front()) != std::string_view::npos;
  };
  for (std::string line; std::getline(lines, line) && isOfHead(line);) head += line + "\n";
  return head;
}

/// @param read  with the text, and the name of the file
template <typename Read>
auto readFiveAxisFile(const std::string& path, const Read& read) {
  try {
    return read(readTextFile(path), std::filesystem::path(path).filename().string());
  } catch (const InvalidConfig& error) {
    throw InvalidProgram("'" + path + "' is five-axis G-code: " + error.what() +
                         "; expected machine.name to be the machine that it was written for");
  }
}

}  // namespace

bool isGcodeFile(const std::string& path) { return smallSuffix(path) == ".gcode"; }

bool isProgramFile(const std::string& path) { return isRobotFile(path) || isGcodeFile(path); }

Toolpath readProgram(const std::string& path, const ProgramSettings& settings,
                     const MachineSettings& machine) {
  if (isRobotFile(path))
    return programRunner(path) == ProgramRunner::RapidRobot ? readRapidFile(path)
                                                            : readRobotProgramFile(path);
  if (isFiveAxisProgram(headOf(path)))
    return readFiveAxisFile(path, [&](const std::string& text, const std::string& name) {
      return readFiveAxis(text, *kinematicModelOf(machine), settings.five_axis, settings, name);
    });
  return toolpathFromGcodeFile(path, settings);
}

std::optional<StatedMotion> readStatedMotion(const std::string& path, const ProgramSettings& settings,
                                             const KinematicModel& model) {
  if (!isProgramFile(path)) return std::nullopt;
  if (isRobotFile(path) && isSixAxisArm(model))
    return programRunner(path) == ProgramRunner::RapidRobot ? readRapidMotionFile(path, model)
                                                            : readRobotMotionFile(path, model);
  if (isRobotFile(path) || !isFiveAxisProgram(headOf(path))) return std::nullopt;
  return readFiveAxisFile(path, [&](const std::string& text, const std::string& name) {
    return readFiveAxisMotion(text, model, settings.five_axis, settings, name);
  });
}

std::vector<Point3> toolOffsetsIn(const std::string& path) {
  std::vector<Point3> offsets_mm;
  if (!isGcodeFile(path)) return offsets_mm;
  std::istringstream head(headOf(path));
  for (std::string line; std::getline(head, line);)
    readToolOffset(std::string_view(line).substr(1), offsets_mm);
  return offsets_mm;
}

bool isToolpathFile(const std::string& path) { return smallSuffix(path) == ".csv"; }

Toolpath readToolpathFile(const std::string& path, const ProgramSettings& settings,
                          const MachineSettings& machine) {
  if (isToolpathFile(path))
    return readCsv(readTextFile(path), std::filesystem::path(path).filename().string());
  if (isProgramFile(path)) return readProgram(path, settings, machine);
  throw InvalidInput("'" + path +
                     "' is neither a program nor a toolpath; expected .gcode, .csv or a robot's program "
                     "(.mod, .src, .script, .ls, .jbi)");
}

}  // namespace lamina
