// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A module of a program.
struct RapidText {
  std::string file;  ///< its name, for errors
  std::string_view text;
};

/// Reads a program in the subset of RAPID that `RapidProgram` writes, in coordinates of the work object:
/// moves are deposition where the process is on. Roles, beads, layers and where paths begin come from the
/// comments.
///
/// @param modules  main's first
/// @throws InvalidProgram naming file and line, what was found and what was expected: instructions, data,
///   speeds, zones or targets that are not known; moves that no comment describes, or whose process
///   is not that of their path
Toolpath readRapid(const std::vector<RapidText>& modules, const std::string& part_name);

/// Reads a file and, beside it, those of the modules that it names; the toolpath is named after it.
/// @throws FileError if one cannot be read
/// @throws InvalidProgram as above
Toolpath readRapidFile(const std::string& path);

}  // namespace lamina
