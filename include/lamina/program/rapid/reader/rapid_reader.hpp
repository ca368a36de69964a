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

/// The same with what the program states beside its toolpath.
EquippedToolpath readEquippedRapid(const std::vector<RapidText>& modules, const std::string& part_name);
EquippedToolpath readEquippedRapidFile(const std::string& path);

/// The same with the joints by which an arm runs it. Under `ConfL\\On` those are the joints of the
/// configuration in each target; under `ConfL\\Off` the nearest to those before, from the joints of the
/// approach on, or else from the first target's configuration. External axes stand as in the targets. A
/// target that has no such joints is a fault, `configuration` or `out_of_reach`; nothing else is judged.
/// @throws InvalidProgram as above; also if the tool or work object that the program declares is another than
///   that of the arm's description, or a target lacks one of its external axes
/// @throws InvalidConfig if the kinematic model is no six-axis arm
StatedMotion readRapidMotion(const std::vector<RapidText>& modules, const std::string& part_name,
                             const KinematicModel& arm);
StatedMotion readRapidMotionFile(const std::string& path, const KinematicModel& arm);

}  // namespace lamina
