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

/// Note that precedes the moves to the part and away from it.
constexpr std::string_view kApproachNote = "approach";
constexpr std::string_view kRetractNote = "retract";

/// Beginning of the note of joint values after a move of joints that states only the pose of the tip [deg].
constexpr std::string_view kJointsNote = "stands";

/// Beginning of the note before a wait that belongs to the toolpath, not to the process.
constexpr std::string_view kDwellNote = "dwell";

/// Beginning of the note of mass and centre of gravity of what the flange carries [kg, mm].
constexpr std::string_view kLoadNote = "load";

/// Beginning of the note of the variable that switches the process off for a dry run.
constexpr std::string_view kDryFlagNote = "dry_flag";

/// Beginning of the note of the speed of a dry run, in percent of the program's.
constexpr std::string_view kDrySpeedNote = "dry_speed";

/// Variable of programs in KRL that states whether a run is dry: reading the controller's own flag would stop
/// the tip.
constexpr std::string_view kDryVariable = "lamina_dry";

/// Variable by which programs that run dry at a speed of their own multiply their speeds.
constexpr std::string_view kDrySpeedVariable = "lamina_speed";

/// Beginning of the note of an external axis, in the controller's order: joint, sense and zero [mm, deg].
constexpr std::string_view kExternalNote = "external";

/// Beginnings of the notes on pulses of jobs in INFORM: in a degree of each joint, and in a mm or a degree of
/// each external axis.
constexpr std::string_view kPulsesNote = "pulses";
constexpr std::string_view kExternalPulsesNote = "external_pulses";

/// Beginnings of the notes before statements by which a program in KRL starts and ends its arc.
constexpr std::string_view kArcOnNote = "arc_on";
constexpr std::string_view kArcOffNote = "arc_off";

/// The comments that hold a note, in a language whose comments begin with `lead` and hold at most `width`
/// further characters. The first one begins with "# "; "#+ " begins further ones, with the words that did not
/// fit.
std::vector<std::string> noteComments(std::string_view note, std::string_view lead, std::size_t width);

/// Joins the comments of a program into notes; comments that are no notes change nothing. `take` returns the
/// note joined so far, and removes it.
class NoteGathering {
 public:
  /// Adds a comment.
  /// @param comment  without lead
  /// @return whether it is part of a note
  bool add(std::string_view comment, std::size_t line);
  bool isEmpty() const { return text_.empty(); }
  /// Whether the comment continues the note before.
  static bool continuesNote(std::string_view comment);
  std::size_t line() const { return line_; }
  std::string take();

 private:
  std::string text_;
  std::size_t line_ = 0;
};

/// The notes on a path. They state the layer if a new one begins, the role, whether the path is closed,
/// retracted or begins with a move of its own, the number of its moves, runs of motions with one bead, and
/// names of process values.
/// @param rise_mm  rise of the part's origin along the layers' normal
std::vector<std::string> pathNotes(const Toolpath& toolpath, const RobotPath& path, bool begins_layer,
                                   double rise_mm);

/// The note on a frame: "name x y z w x y z" [mm, 6 decimals; 9 for the rotation].
std::string frameNote(std::string_view name, const Eigen::Isometry3d& frame);

}  // namespace lamina
