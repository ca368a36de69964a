// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "lamina/toolpath/waypoint_index.hpp"
#include "program/robot/notes/path_notes.hpp"

namespace lamina {

enum class ProcessState : std::uint8_t { Off, On };

/// A move of a robot's tip in a program.
struct AssembledMove {
  Point3 point = Point3::Zero();  ///< [mm, bed]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  double feed_mm_s = 0.0;
  std::map<std::string, double> values;  ///< process values by name
  std::size_t index = 0;                 ///< index by which the caller identifies the move
};

/// A waypoint of a program's toolpath, and the move that ends there.
struct AssembledStation {
  WaypointIndex at;
  AssembledMove move;
};

/// A program in the order in which its robot runs it.
struct AssembledProgram {
  Toolpath toolpath;
  std::vector<AssembledStation> stations;  ///< the start of each path, and the end of each of its motions
};

/// How error messages refer to the notes of a language.
struct NoteStyle {
  std::string mark;   ///< beginning of notes: "!# "
  std::string place;  ///< what notes precede: "the procedure"
  std::string whole;  ///< what notes describe: "the procedure"
};

/// Assembles a toolpath from moves, in the order in which they are run, and from the notes on their paths.
/// All functions throw InvalidProgram, naming file and line, if these contradict each other.
class PathAssembly {
 public:
  explicit PathAssembly(NoteStyle style) : style_(std::move(style)) {}

  /// Begins a file or procedure that has moves, with its notes.
  void begin(std::vector<PathNote> notes, const std::string& file);
  /// Adds the note of a path that begins within a file, or continues in another one.
  void addNote(const PathNote& note, const std::string& file);
  /// Adds a move.
  /// @param process  state of the process during the move
  void add(const AssembledMove& move, ProcessState process, std::size_t line);
  /// Adds a wait of the tool after the moves so far [s]. Consecutive waits at one place become one.
  void addDwell(double duration_s, std::size_t line);
  /// Ends the file or procedure.
  void end(std::size_t line);

  AssembledProgram finish();

 private:
  [[noreturn]] void refuse(std::size_t line, const std::string& what) const;
  void openPath(std::size_t line);
  void addStart(const AssembledMove& move, ProcessState process, std::size_t line);
  void addMotion(const AssembledMove& move, ProcessState process, std::size_t line);
  void closePath();
  void addStations(std::size_t waypoints);
  std::vector<Bead> beads() const;
  std::vector<ProcessValue> values(const Path& path) const;
  [[noreturn]] void refuseOpen(const std::string& what) const;

  NoteStyle style_;
  std::vector<PathNote> notes_;
  std::string file_;
  std::size_t note_ = 0;   ///< index of the note whose moves come now
  std::size_t moves_ = 0;  ///< number of its moves so far
  std::optional<AssembledMove> last_;

  std::optional<PathNote> open_;  ///< the path that is being read
  std::string open_file_;
  std::vector<AssembledMove> poses_;  ///< start of the path, and the end of each motion
  std::vector<PathEvent> events_;     ///< events of the path
  AssembledProgram program_;
};

}  // namespace lamina
