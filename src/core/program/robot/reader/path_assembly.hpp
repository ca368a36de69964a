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
  std::map<std::string, double> values;  ///< of the process, by name
  std::size_t index = 0;                 ///< the reader's own
};

/// A waypoint of a program's toolpath, and the move that leads there.
struct AssembledStation {
  WaypointIndex at;
  AssembledMove move;
};

/// A program as its robot runs it.
struct AssembledProgram {
  Toolpath toolpath;
  std::vector<AssembledStation> stations;  ///< where each path starts, and the end of each of its motions
};

/// How a language's notes are spoken of in errors.
struct NoteStyle {
  std::string mark;   ///< that begins notes: "!# "
  std::string place;  ///< what they stand before: "the procedure"
  std::string whole;  ///< what they are of: "the procedure"
};

/// Makes a toolpath of moves, in the order in which they are run, and of the notes that describe their paths.
/// All refuse by InvalidProgram, naming file and line, what does not fit together.
class PathAssembly {
 public:
  explicit PathAssembly(NoteStyle style) : style_(std::move(style)) {}

  /// A file or procedure with moves begins, whose notes are these.
  void begin(std::vector<PathNote> notes, const std::string& file);
  /// A path begins amid a file, or goes on in another.
  void addNote(const PathNote& note, const std::string& file);
  /// @param process  while it runs
  void add(const AssembledMove& move, ProcessState process, std::size_t line);
  /// The tool waits where it stands, after the moves so far [s]. Waits at one place are one.
  void addDwell(double duration_s, std::size_t line);
  /// The file or procedure ends.
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
  std::size_t note_ = 0;   ///< the one whose moves come
  std::size_t moves_ = 0;  ///< of it, so far
  std::optional<AssembledMove> last_;

  std::optional<PathNote> open_;  ///< the path that is being read
  std::string open_file_;
  std::vector<AssembledMove> poses_;  ///< where it starts, and at the end of each motion
  std::vector<PathEvent> events_;     ///< of the path
  AssembledProgram program_;
};

}  // namespace lamina
