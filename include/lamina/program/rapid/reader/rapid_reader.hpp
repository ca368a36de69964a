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
  std::string file;  ///< its name, for errors
  std::string_view text;
};

/// Reads a program in the subset of RAPID that `RapidProgram` writes; the toolpath is in coordinates of the
/// work object. Moves deposit while the process is switched on. Roles, beads, layers and where paths begin
/// come from the comments.
///
/// @param modules  the one with the procedure `main` first
/// @throws InvalidProgram naming file and line, what was found and what was expected: instructions, data,
///   speeds, zones or targets that are not known; moves of no path that a comment describes; moves with the
///   process on in a travel, or off in a path that deposits
Toolpath readRapid(const std::vector<RapidText>& modules, const std::string& part_name);

/// Reads a file, and from the same folder the modules that its comments name; the toolpath is named after the
/// file.
/// @throws FileError if one cannot be read
/// @throws InvalidProgram as above
Toolpath readRapidFile(const std::string& path);

/// Reads a program likewise, and also returns what it states besides the toolpath: outputs, external axes.
EquippedToolpath readEquippedRapid(const std::vector<RapidText>& modules, const std::string& part_name);
EquippedToolpath readEquippedRapidFile(const std::string& path);

/// Reads a program likewise, and also returns the joints at which an arm reaches each target. Under
/// `ConfL\\On` these are the joints in the configuration that the target states. Under `ConfL\\Off` they are
/// the joints nearest to those at the target before; the first target takes those nearest to the approach's,
/// or, without an approach by joints, those of its configuration. External axes stand as in the targets. A
/// target without such joints is listed as a fault, `configuration` or `out_of_reach`; limits, collisions and
/// singularities are not checked.
/// @throws InvalidProgram as above; also if the tool or work object that the program declares is another than
///   that of the arm's description, or a target lacks one of its external axes
/// @throws InvalidConfig if the kinematic model is no six-axis arm
StatedMotion readRapidMotion(const std::vector<RapidText>& modules, const std::string& part_name,
                             const KinematicModel& arm);
StatedMotion readRapidMotionFile(const std::string& path, const KinematicModel& arm);

}  // namespace lamina
