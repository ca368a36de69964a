// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/robot_files.hpp"

#include <algorithm>
#include <charconv>
#include <deque>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/rapid_files.hpp"
#include "lamina/program/robot/robot_writer.hpp"

namespace lamina {
namespace {

std::vector<RobotFile> programOf(const RobotProgramRequest& request, const PlacedToolpath& placed) {
  if (!placed.frame.program_from_bed.matrix().isIdentity(0.0))
    throw InvalidInput(
        "the machine's axes stand askew to its bed; a program for a robot reports coordinates of the bed, "
        "expected a machine whose axes are at right angles");
  if (!placed.joints)
    throw InvalidInput(
        std::string("a program in ") + toString(request.language) +
        " begins with a move of joints, but none are known; expected a machine that is an arm with "
        "six joints (machine.name, machine.urdf)");
  const RobotMotion robot{placed.joints->model, placed.joints->path};
  return robotProgram(placed.toolpath, placed.frame.bed_from_part, request, &robot);
}

struct NumberedName {
  std::string name;
  int number = 0;  ///< 0 without one
};

/// Of a file such as part_2.src.
NumberedName numberedName(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  const std::size_t line = stem.rfind('_');
  if (line == std::string::npos) return {stem, 0};
  int number = 0;
  const char* const end = stem.data() + stem.size();
  const auto read = std::from_chars(stem.data() + line + 1, end, number);
  if (read.ec != std::errc() || read.ptr != end || number < 1) return {stem, 0};
  return {stem.substr(0, line), number};
}

bool isStated(const Toolpath& toolpath, const std::string& value) {
  const auto names = [&](const ProcessValue& stated) { return stated.name == value; };
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (std::any_of(path.values.begin(), path.values.end(), names)) return true;
  return false;
}

std::vector<RobotLevel> unstatedLevels(const Toolpath& toolpath, const std::string& levels) {
  std::vector<RobotLevel> unstated;
  std::vector<RobotLevel> listed = robotLevels(levels);
  for (RobotLevel& level : listed)
    if (!isStated(toolpath, level.name)) unstated.push_back(std::move(level));
  return unstated;
}

/// All files or none.
/// @return their names
std::vector<std::string> commitFiles(const std::string& path, const std::vector<RobotFile>& program) {
  const std::filesystem::path first(path);
  std::vector<std::string> names;
  std::deque<AtomicFile> files;
  for (std::size_t i = 0; i < program.size(); ++i) {
    names.push_back(i == 0 ? first.filename().string() : program[i].name);
    if (i > 0 && program[i].name == names.front())
      throw InvalidConfig("the file '" + program[i].name + "' would be written over '" + path +
                          "', which runs it; expected another robot_program.name");
    AtomicFile& file = files.emplace_back(i == 0 ? path : (first.parent_path() / program[i].name).string());
    file.write(program[i].text);
  }
  // The first last: it names the others.
  for (auto file = files.rbegin(); file != files.rend(); ++file) file->commit();
  return names;
}

}  // namespace

ProgramRunner programRunner(const std::string& path) {
  if (isRapidFile(path)) return ProgramRunner::RapidRobot;
  return robotLanguageOf(path) ? ProgramRunner::OtherRobot : ProgramRunner::Machine;
}

bool isRobotFile(const std::string& path) { return programRunner(path) != ProgramRunner::Machine; }

std::string robotLanguageName(const std::string& path) {
  const auto language = robotLanguageOf(path);
  return language ? toString(*language) : "RAPID";
}

void writeRobotProgram(RobotLanguage language, const PlacedToolpath& placed,
                       const RobotProgramSettings& settings, const TextSink& sink) {
  const std::vector<RobotFile> files = programOf({language, "lamina", settings}, placed);
  if (files.size() > 1)
    throw InvalidConfig(std::string("the program in ") + toString(language) + " takes " +
                        std::to_string(files.size()) + " files; expected a place for each, or fewer points");
  sink(files.front().text);
}

std::vector<std::string> filesOfLongerProgram(const std::string& path,
                                              const std::vector<std::string>& names) {
  const std::filesystem::path last(names.back());
  const bool is_single = last.stem() == std::filesystem::path(names.front()).stem();
  const NumberedName end = is_single ? NumberedName{last.stem().string(), 0} : numberedName(last);
  std::map<std::pair<int, std::string>, std::string> left;
  std::error_code unreadable;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  for (const auto& entry : std::filesystem::directory_iterator(folder.empty() ? "." : folder, unreadable)) {
    const NumberedName numbered = numberedName(entry.path());
    if (numbered.name != end.name || numbered.number <= end.number) continue;
    const std::string extension = entry.path().extension().string();
    const bool is_of_program = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
      return std::filesystem::path(name).extension() == extension;
    });
    if (is_of_program) left[{numbered.number, extension}] = entry.path().filename().string();
  }
  std::vector<std::string> files;
  files.reserve(left.size());
  for (const auto& [place, name] : left) files.push_back(name);
  return files;
}

RobotWriting writeRobotFiles(const std::string& path, const PlacedToolpath& placed,
                             const RobotProgramSettings& settings) {
  const RobotLanguage language = *robotLanguageOf(path);
  const std::string name = std::filesystem::path(path).stem().string();
  return {commitFiles(path, programOf({language, name, settings}, placed)),
          speedRounding(placed.toolpath, language, settings),
          unstatedLevels(placed.toolpath, settings.levels)};
}

RobotWriting writeRobotFiles(const std::string& path, const Toolpath& over_bed,
                             const RobotProgramSettings& settings) {
  const RobotLanguage language = *robotLanguageOf(path);
  if (language == RobotLanguage::UrScript)
    throw InvalidInput("'" + path +
                       "' would be a script without joints; expected another language: poses in URScript are "
                       "over the robot's base, which only joints state");
  const std::string name = std::filesystem::path(path).stem().string();
  return {
      commitFiles(path, robotProgram(over_bed, Eigen::Isometry3d::Identity(), {language, name, settings})),
      speedRounding(over_bed, language, settings), unstatedLevels(over_bed, settings.levels)};
}

}  // namespace lamina
