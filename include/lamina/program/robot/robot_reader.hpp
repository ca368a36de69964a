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

/// Reads a program in the subset of its language that `robotProgram` writes, into coordinates of the bed.
/// Comments state roles, beads, layers and the beginnings of paths. Moves deposit while the process is
/// switched on. The language follows from the suffix of the first file.
///
/// @param files  first the file that is loaded first; then, in any order, the files that it runs, and data
///   files
/// @throws InvalidProgram naming file and line, what was found and what was expected: statements that are not
///   known; files that are missing; moves of no path that a comment describes; moves with the process on in a
///   travel, or off in a path that deposits
Toolpath readRobotProgram(const std::vector<RobotFile>& files, const std::string& part_name);

/// Reads a file, and from the same folder the files that it runs; the toolpath is named after the file.
/// @throws FileError if it cannot be read
/// @throws InvalidProgram as above
Toolpath readRobotProgramFile(const std::string& path);

/// Reads a program as `readRobotProgram` does, and also returns what it states besides the toolpath: outputs
/// and external axes.
EquippedToolpath readEquippedRobotProgram(const std::vector<RobotFile>& files, const std::string& part_name);
EquippedToolpath readEquippedRobotProgramFile(const std::string& path);

/// Reads a program as `readRobotProgram` does, and also returns the joint values at which an arm reaches each
/// pose: they are nearest to the joint values at the previous pose; at the first pose, to those of the joint
/// move that approaches the part. External axes have the values of the moves. A pose without such joint
/// values is listed as a fault, `out_of_reach`; limits, collisions and singularities are not checked.
/// @throws InvalidProgram as `readRobotProgram`; if the program does not state tool and bed, or states others
///   than those of the arm's description, a move does not state one of the arm's external axes, or no joint
///   move approaches the part
/// @throws InvalidConfig if the kinematic model is no six-axis arm
StatedMotion readRobotMotion(const std::vector<RobotFile>& files, const std::string& part_name,
                             const KinematicModel& arm);
StatedMotion readRobotMotionFile(const std::string& path, const KinematicModel& arm);

}  // namespace lamina
