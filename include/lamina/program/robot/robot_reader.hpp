// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/robot/robot_writer.hpp"
#include "lamina/program/stated_equipment.hpp"
#include "lamina/program/stated_motion.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Reads a program in the subset of its language that `robotProgram` writes, in coordinates of the bed.
/// Roles, beads, layers and where paths begin come from the comments; moves are deposition where the process
/// is on. The language is that of the first file's suffix.
///
/// @param files  the one that is loaded first, then those that it runs and their data files, in any order
/// @throws InvalidProgram naming file and line, what was found and what was expected: statements that are not
///   known, files that are missing, moves that no comment describes, or whose process is not that of their
///   path
Toolpath readRobotProgram(const std::vector<RobotFile>& files, const std::string& part_name);

/// Reads a file and, beside it, those that it runs; the toolpath is named after it.
/// @throws FileError if it cannot be read
/// @throws InvalidProgram as above
Toolpath readRobotProgramFile(const std::string& path);

/// The same with what the program states beside its toolpath.
EquippedToolpath readEquippedRobotProgram(const std::vector<RobotFile>& files, const std::string& part_name);
EquippedToolpath readEquippedRobotProgramFile(const std::string& path);

/// The same with the joints by which an arm runs it: from those of the move that comes to the part on, the
/// nearest to those before at each pose. External axes stand as in the moves. A pose that has no such joints
/// is a fault, `out_of_reach`; nothing else is judged.
/// @throws InvalidProgram as above; also if tool or bed, as the program states them, are others than those of
///   the arm's description, a move lacks an external axis, or no move of the joints comes to the part
/// @throws InvalidConfig if the kinematic model is no six-axis arm
StatedMotion readRobotMotion(const std::vector<RobotFile>& files, const std::string& part_name,
                             const KinematicModel& arm);
StatedMotion readRobotMotionFile(const std::string& path, const KinematicModel& arm);

}  // namespace lamina
