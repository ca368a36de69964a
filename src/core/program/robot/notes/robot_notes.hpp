// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "program/robot/writer/robot_paths.hpp"

namespace lamina {

/// Notes that begin the moves which lead to the part, and away from it.
constexpr std::string_view kApproachNote = "approach";
constexpr std::string_view kRetractNote = "retract";

/// Begins the joints of a move of them that states but the pose to which they take the tip [deg].
constexpr std::string_view kJointsNote = "stands";

/// Begins a wait that is the toolpath's, not the process's.
constexpr std::string_view kDwellNote = "dwell";

/// Begin notes of the statements by which a program in KRL starts and ends its arc.
constexpr std::string_view kArcOnNote = "arc_on";
constexpr std::string_view kArcOffNote = "arc_off";

/// The comments of a note in a language whose comments begin with `lead` and hold no more than `width`
/// characters after it: "# " before the first words, "#+ " before those for which there was no room.
std::vector<std::string> noteComments(std::string_view note, std::string_view lead, std::size_t width);

/// Adds a comment, without its lead, to the notes so far; others than notes change nothing.
/// @return whether the note of the comments before is whole, which then stands in `whole`
class NoteGathering {
 public:
  /// @param comment  without lead
  /// @return whether it is part of a note
  bool add(std::string_view comment, std::size_t line);
  bool isEmpty() const { return text_.empty(); }
  /// Whether the comment goes on with the note so far.
  static bool goesOn(std::string_view comment);
  std::size_t line() const { return line_; }
  std::string take();

 private:
  std::string text_;
  std::size_t line_ = 0;
};

/// What a path is: layer where a new one begins, role, whether it is closed, retracted or begins with a move
/// of its own, the number of its moves, runs of motions with one bead, names of process values.
/// @param rise_mm  of the part along the layers' normal
std::vector<std::string> pathNotes(const Toolpath& toolpath, const RobotPath& path, bool begins_layer,
                                   double rise_mm);

/// "name x y z w x y z": a frame [mm, 6 decimals; 9 of the turn].
std::string frameNote(std::string_view name, const Eigen::Isometry3d& frame);

}  // namespace lamina
