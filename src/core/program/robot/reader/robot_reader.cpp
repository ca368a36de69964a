// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/robot/robot_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "program/robot/reader/robot_parser.hpp"
#include "program/robot/reader/robot_run.hpp"
#include "program/robot/robot_cell.hpp"

namespace lamina {
namespace {

/// The text of a file beside the first; nothing if there is none.
using BesideFile = std::function<std::optional<std::string>(const std::string& name)>;

/// What a program consists of, file by file, each once.
class RobotProgramFiles {
 public:
  RobotProgramFiles(const std::string& first, BesideFile beside)
      : grammar_(grammarOf(first)), beside_(std::move(beside)) {
    add(first, "the program");
  }

  std::vector<RobotScriptFile> read() {
    for (std::size_t next = 0; next < files_.size(); ++next) {
      RobotScriptFile& file = files_[next];
      for (const ReadStatement& statement : file.statements) {
        const std::optional<std::string> called = calledBy(statement, file.name);
        if (!called) continue;
        const std::string place = "'" + file.name + "' line " + std::to_string(statement.line);
        if (next > 0)
          throw InvalidProgram(place + ": a file that is run runs another; expected that of the first alone");
        called_.emplace_back(*called, place);
      }
      if (next == 0)
        for (const auto& [name, place] : called_) add(name + grammar_.suffix, place);
    }
    return std::move(files_);
  }

  const RobotGrammar& grammar() const { return grammar_; }

 private:
  static RobotGrammar grammarOf(const std::string& file) {
    if (const auto language = robotLanguageOf(file)) return robotGrammar(*language);
    throw InvalidProgram("'" + file +
                         "' has no suffix of a robot's language; expected .src, .script, .ls or .jbi");
  }

  static std::optional<std::string> calledBy(const ReadStatement& statement, const std::string& file) {
    if (const auto* call = std::get_if<FileCall>(&statement.what)) return call->name;
    const auto* note = std::get_if<NoteLine>(&statement.what);
    if (note == nullptr) return std::nullopt;
    NoteWords words(note->text, statement.line, file);
    if (!words.take("file")) return std::nullopt;
    const std::string name(words.next());
    words.expectEnd();
    const bool is_plain = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
      return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' ||
             c == '-';
    });
    if (!is_plain) words.refuse(name, "the name of a program");
    return name;
  }

  void add(const std::string& name, const std::string& place) {
    if (!names_.insert(name).second)
      throw InvalidProgram(place + ": '" + name + "' is run again; expected each file once");
    const std::optional<std::string> text = beside_(name);
    if (!text)
      throw InvalidProgram(place + ": the file '" + name + "' is not there; expected it beside the first");
    RobotSourceText source{name, *text, "", std::nullopt};
    if (!grammar_.data_suffix.empty()) {
      source.data_file = std::filesystem::path(name).stem().string() + grammar_.data_suffix;
      source.data = beside_(source.data_file);
    }
    files_.push_back({name, grammar_.parse(source)});
  }

  RobotGrammar grammar_;
  BesideFile beside_;
  std::set<std::string> names_;
  std::vector<std::pair<std::string, std::string>> called_;  ///< and where
  std::vector<RobotScriptFile> files_;
};

BesideFile among(const std::vector<RobotFile>& files) {
  return [&files](const std::string& name) -> std::optional<std::string> {
    for (const RobotFile& file : files)
      if (file.name == name) return file.text;
    return std::nullopt;
  };
}

BesideFile inFolderOf(const std::filesystem::path& first) {
  return [first](const std::string& name) -> std::optional<std::string> {
    const std::filesystem::path path = pathInAnyCase((first.parent_path() / name).string());
    std::error_code unknown;
    if (path != first && !std::filesystem::is_regular_file(path, unknown)) return std::nullopt;
    return readTextFile(path.string());
  };
}

RobotRunning runningFrom(const std::string& first, BesideFile beside, const std::string& part_name) {
  RobotProgramFiles files(first, std::move(beside));
  const std::vector<RobotScriptFile> scripts = files.read();
  RobotRunning running = runRobot(scripts, files.grammar().note_mark);
  if (running.program.toolpath.layers.empty())
    throw InvalidProgram("'" + first + "' has no motion; expected a program that deposits");
  running.program.toolpath.part_name = part_name;
  return running;
}

const std::string& firstOf(const std::vector<RobotFile>& files) {
  if (files.empty()) throw InvalidProgram("there is no file; expected one at least");
  return files.front().name;
}

RobotRunning runningOfFile(const std::string& path) {
  const std::filesystem::path file(path);
  return runningFrom(file.filename().string(), inFolderOf(file), file.stem().string());
}

EquippedToolpath equipped(RobotRunning running) {
  return {std::move(running.program.toolpath), std::move(running.equipment)};
}

StatedMotion motionOf(const std::string& file, RobotRunning running, const KinematicModel& arm) {
  if (const auto language = robotLanguageOf(file)) requireController(*language, running.head.map, arm);
  return robotMotionOf(std::move(running), arm);
}

}  // namespace

Toolpath readRobotProgram(const std::vector<RobotFile>& files, const std::string& part_name) {
  return runningFrom(firstOf(files), among(files), part_name).program.toolpath;
}

Toolpath readRobotProgramFile(const std::string& path) { return runningOfFile(path).program.toolpath; }

EquippedToolpath readEquippedRobotProgram(const std::vector<RobotFile>& files, const std::string& part_name) {
  return equipped(runningFrom(firstOf(files), among(files), part_name));
}

EquippedToolpath readEquippedRobotProgramFile(const std::string& path) {
  return equipped(runningOfFile(path));
}

StatedMotion readRobotMotion(const std::vector<RobotFile>& files, const std::string& part_name,
                             const KinematicModel& arm) {
  return motionOf(firstOf(files), runningFrom(firstOf(files), among(files), part_name), arm);
}

StatedMotion readRobotMotionFile(const std::string& path, const KinematicModel& arm) {
  return motionOf(path, runningOfFile(path), arm);
}

}  // namespace lamina
