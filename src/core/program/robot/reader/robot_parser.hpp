// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/program/robot/robot_program_settings.hpp"
#include "program/robot/notes/robot_notes.hpp"
#include "program/robot/reader/line_cursor.hpp"
#include "program/robot/robot_statement.hpp"

namespace lamina {

/// A file to be parsed, with its data file. Everything must outlive the statements read from it.
struct RobotSourceText {
  std::string file;
  std::string_view text;
  std::string data_file;                 ///< name of the data file
  std::optional<std::string> data = {};  ///< text of the data file of the same name, if there is one
};

/// What a language's reader needs to define.
struct RobotGrammar {
  std::vector<ReadStatement> (*parse)(const RobotSourceText& source) = nullptr;
  std::string note_mark;    ///< "; # ", for errors
  std::string suffix;       ///< suffix of the files that a program runs
  std::string data_suffix;  ///< suffix of data files; empty if there are none
};

RobotGrammar robotGrammar(RobotLanguage language);

/// Collects the statements of a file, with the notes among its comments.
class StatementList {
 public:
  /// @param comment  without lead
  void addComment(std::string_view comment, std::size_t line);
  void add(RobotStatement statement, std::size_t line);
  /// Sets the weave schedule of the arc that the last statement starts.
  /// @return false if the last statement starts no arc
  bool weaveArc(int schedule);
  /// Opens the condition under which the process is switched: a dry run passes over what it encloses.
  /// @return false if one is open
  bool openDryCondition();
  /// @return false unless a condition is open that encloses one switch of the process, and nothing else
  bool closeDryCondition();
  bool isConditionOpen() const { return conditional_.has_value(); }
  std::vector<ReadStatement> take();

 private:
  void flush();

  std::vector<ReadStatement> statements_;
  NoteGathering note_;
  std::optional<std::size_t> conditional_;  ///< number of statements before the condition that is open
};

/// Limits of values read, wider than those of any robot.
constexpr double kFarthestRead = 1e5;   // mm
constexpr double kGreatestAngle = 1e5;  // deg
constexpr double kSlowestRead = 1e-3;   // mm/s
constexpr double kFastestRead = 1e5;    // mm/s
constexpr double kLongestWait = 1e6;    // s
constexpr double kGreatestLevel = 1e9;  // of an analogue output
constexpr int kMostOutputs = 99999;     // number of the last

/// What a condition of a dry run may enclose, for errors.
constexpr const char* kOneSwitch = "a condition of a dry run before it, with one switch of the process in it";

}  // namespace lamina
