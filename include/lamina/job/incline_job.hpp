// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/gcode_rewrite/gcode_rewrite.hpp"
#include "lamina/kinematics/model/build_space.hpp"

namespace lamina {

/// A G-code program to be transformed, where the result is written, and how.
struct InclineJob {
  std::string program;
  std::string output;                   ///< empty for the file that `inclinedName` names
  std::shared_ptr<const SpaceMap> map;  ///< map from positions in the program to positions over the bed
  /// Map from positions over the bed to values of the machine's axes; nullptr if both are the same.
  std::shared_ptr<const SpaceMap> axes;
  RewriteSettings settings;
};

/// Default path of the output: part_rotate.gcode beside part.gcode.
/// @throws InvalidInput if the program does not end in .gcode
std::string inclinedName(const std::string& program);

/// Build volume of the large gantry for which the method was developed: 1300 x 2500 x 1000 mm from the
/// origin.
Box3 largeGantryRoom();

/// Volume over the bed that a machine's nozzle reaches [mm, bed frame]: the bounding box of its build space,
/// without what lies below the bed.
Box3 machineRoom(const BuildSpace& space);

/// Transforms the program.
/// @throws InvalidInput if program or output do not end in .gcode, the output is the program, or there is no
///   map
/// @throws as `rewriteProgram`
RewriteReport runInclineJob(const InclineJob& job, Progress& progress);

}  // namespace lamina
