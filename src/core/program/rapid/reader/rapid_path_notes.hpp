// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "program/rapid/reader/rapid_cursor.hpp"

namespace lamina {

/// So many motions lay this bead.
struct BeadRun {
  Bead bead;
  std::size_t motions = 0;
};

/// What the comments before a procedure report of a path, or of what is left of one.
struct PathNote {
  std::size_t line = 0;
  std::optional<ToolpathLayer> layer;  ///< that begins with the path; without paths
  bool is_resumed = false;             ///< goes on with the last path of the procedure before
  PathRole role = PathRole::Travel;
  bool is_closed = false;
  bool is_retracted = false;
  bool is_turned = false;
  std::size_t moves = 0;  ///< in this procedure
  std::vector<BeadRun> beads;
};

/// Reads the notes among the comments; others are left out.
/// @param file  for errors
/// @throws InvalidProgram naming file and line
std::vector<PathNote> readPathNotes(const std::vector<RapidComment>& comments, const std::string& file);

/// The names of the modules besides main, from the comments at its head.
std::vector<std::string> readModuleNotes(const std::vector<RapidComment>& comments, const std::string& file);

}  // namespace lamina
