// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/stated_equipment.hpp"
#include "lamina/program/stated_motion.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A module of a program.
struct RapidText {
  std::string file;  ///< name of the file, for errors
  std::string_view text;
};

/// Reads a program in the subset of RAPID that `RapidProgram` writes; the toolpath is in coordinates of the
/// work object. Moves deposit while the process is switched on. Comments state roles, beads, layers and the
/// beginnings of paths.
///
/// @param modules  the module with the procedure `main` first
/// @throws InvalidProgram naming file and line, what was found and what was expected: instructions, data,
///   speeds, zones or targets that are not known; moves of no path that a comment describes; moves with the
///   process on in a travel, or off in a path that deposits
Toolpath readRapid(const std::vector<RapidText>& modules, const std::string& part_name);

/// Reads a file, and from the same folder the modules that its comments name; the toolpath is named after the
/// file.
/// @throws FileError if a file cannot be read
/// @throws InvalidProgram as above
Toolpath readRapidFile(const std::string& path);

/// Reads a program as `readRapid` does, and also returns what it states besides the toolpath: outputs and
/// external axes.
EquippedToolpath readEquippedRapid(const std::vector<RapidText>& modules, const std::string& part_name);
EquippedToolpath readEquippedRapidFile(const std::string& path);

/// Reads a program as `readRapid` does, and also returns the joint values at which an arm reaches each
/// target. Under `ConfL\\On` they are in the configuration that the target states. Under `ConfL\\Off` they
/// are nearest to the joint values at the previous target. At the first target they are nearest to the joint
/// values of the approach or, if no joint move approaches the part, in the target's configuration. External
/// axes have the values of the targets. A target without such joint values is listed as a fault,
/// `configuration` or `out_of_reach`; limits, collisions and singularities are not checked.
/// @throws InvalidProgram as `readRapid`; if tool or work object that the program declares differ from those
///   of the arm's description, or a target does not state one of the arm's external axes
/// @throws InvalidConfig if the kinematic model is no six-axis arm
StatedMotion readRapidMotion(const std::vector<RapidText>& modules, const std::string& part_name,
                             const KinematicModel& arm);
StatedMotion readRapidMotionFile(const std::string& path, const KinematicModel& arm);

}  // namespace lamina
