// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/gcode_rewrite/rewrite_report.hpp"
#include "lamina/gcode_rewrite/rewrite_settings.hpp"
#include "lamina/gcode_rewrite/space_map.hpp"

namespace lamina {

/// Paths of a program and of its transformed version.
struct ProgramFiles {
  std::string input;
  std::string output;  ///< written completely or not at all; another file than the input
};

/// The maps by which the points of a program are transformed. They must outlive the transformation.
struct Maps {
  const SpaceMap& map;  ///< map from sliced coordinates to positions over the bed; lift and shift follow
  /// Map from positions over the bed to coordinates of the machine's axes; null if both are the same.
  const SpaceMap* axes = nullptr;
};

/// Transforms the part that a program prints, and leaves the rest of the program as it is. The file is read
/// twice in constant memory: the first pass measures and refuses, the second writes. docs/programs/incline.md
/// explains every rule.
///
/// @throws InvalidConfig as `validate`
/// @throws InvalidProgram naming the line of what cannot be transformed
/// @throws Unreachable naming the line at which the nozzle would leave the limits or deposit below the bed
/// @throws FileError if a file cannot be read or written, or the input changes meanwhile
/// @throws InvalidInput if the output is the input
/// @throws Cancelled if `progress` is cancelled
RewriteReport rewriteProgram(const ProgramFiles& files, const Maps& maps, const RewriteSettings& settings,
                             Progress& progress);

}  // namespace lamina
