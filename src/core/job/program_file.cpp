// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/program_file.hpp"

#include <filesystem>
#include <fstream>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/rapid_files.hpp"
#include "lamina/program/csv/csv_reader.hpp"
#include "lamina/program/five_axis/five_axis_reader.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "lamina/program/rapid/reader/rapid_reader.hpp"

namespace lamina {
namespace {

/// The comments at the head of a program. They state whether it has five axes, so the rest, which may be
/// long, need not be read.
std::string headOf(const std::string& path) {
  std::ifstream file(path);
  std::string head;
  for (std::string line; std::getline(file, line) && !line.empty() && line.front() == ';';)
    head += line + "\n";
  return head;
}

Toolpath readFiveAxisFile(const std::string& path, const ProgramSettings& settings,
                          const MachineSettings& machine) {
  const std::string name = std::filesystem::path(path).filename().string();
  try {
    return readFiveAxis(readFile(path), *kinematicModelOf(machine), settings.five_axis, settings, name);
  } catch (const InvalidConfig& error) {
    throw InvalidProgram("'" + path + "' is five-axis G-code: " + error.what() +
                         "; expected machine.name to be the machine that it was written for");
  }
}

}  // namespace

bool isProgramFile(const std::string& path) {
  return isRapidFile(path) || std::filesystem::path(path).extension() == ".gcode";
}

Toolpath readProgram(const std::string& path, const ProgramSettings& settings,
                     const MachineSettings& machine) {
  if (isRapidFile(path)) return readRapidFile(path);
  if (isFiveAxisProgram(headOf(path))) return readFiveAxisFile(path, settings, machine);
  return toolpathFromGcodeFile(path, settings);
}

bool isToolpathFile(const std::string& path) { return std::filesystem::path(path).extension() == ".csv"; }

Toolpath readToolpathFile(const std::string& path, const ProgramSettings& settings,
                          const MachineSettings& machine) {
  if (isToolpathFile(path)) return readCsv(readFile(path), std::filesystem::path(path).filename().string());
  if (isProgramFile(path)) return readProgram(path, settings, machine);
  throw InvalidInput("'" + path + "' is neither a program nor a toolpath; expected .gcode, .mod or .csv");
}

}  // namespace lamina
