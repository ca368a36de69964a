// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/gcode_rewrite/gcode_rewrite.hpp"
#include "lamina/kinematics/model/build_space.hpp"

namespace lamina {

/// A program, where it goes and how.
struct InclineJob {
  std::string program;
  std::string output;  ///< empty for <program without .gcode>_rotate.gcode beside it
  std::shared_ptr<const SpaceMap> map;
  std::shared_ptr<const SpaceMap> axes;  ///< nullptr for a machine that takes places over the bed
  RewriteSettings settings;
};

/// Where the output goes if the job does not say: part.gcode to part_rotate.gcode.
std::string inclinedName(const std::string& program);

/// The room of the large gantry the method was made for: 1300 x 2500 x 1000 mm from the origin.
Box3 largeGantryRoom();

/// Room of a machine's nozzle over its bed: the box of its build space, what is below the bed left out [mm,
/// bed frame].
Box3 machineRoom(const BuildSpace& space);

/// Transforms the program.
/// @throws InvalidInput if program or output do not end in .gcode, the output is the program, or there is no
///   map
/// @throws as `rewriteProgram`
RewriteReport runInclineJob(const InclineJob& job, Progress& progress);

}  // namespace lamina
