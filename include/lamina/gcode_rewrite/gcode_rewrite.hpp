// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/gcode_rewrite/rewrite_report.hpp"
#include "lamina/gcode_rewrite/rewrite_settings.hpp"
#include "lamina/gcode_rewrite/space_map.hpp"

namespace lamina {

struct ProgramFiles {
  std::string input;
  std::string output;  ///< written whole or not at all; must be another file than the input
};

/// Where the points of a program go. What is referred to must outlive the transform.
struct Maps {
  const SpaceMap& map;  ///< from coordinates as sliced to places over the bed; lift and shift follow
  const SpaceMap* axes = nullptr;  ///< from places over the bed to the machine's coordinates, if they differ
};

/// Maps the part a program prints, and leaves the rest of the program as it is. Two passes over the file in
/// constant memory: the first measures and refuses, the second writes. docs/programs/incline.md explains
/// every rule.
///
/// @throws InvalidConfig as `validate`
/// @throws InvalidProgram naming the line of what cannot be transformed
/// @throws Unreachable naming the line where the nozzle would leave the limits or deposit below the bed
/// @throws FileError if a file cannot be read or written, or the input changes meanwhile
/// @throws InvalidInput if the output is the input
/// @throws Cancelled
RewriteReport rewriteProgram(const ProgramFiles& files, const Maps& maps, const RewriteSettings& settings,
                             Progress& progress);

}  // namespace lamina
