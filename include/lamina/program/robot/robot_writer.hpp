// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "lamina/program/robot/robot_motion.hpp"
#include "lamina/program/robot/robot_program_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A file of a robot's program.
struct RobotFile {
  std::string name;  ///< with its suffix
  std::string text;
};

/// What a program is called and what is written.
struct RobotProgramRequest {
  RobotLanguage language = RobotLanguage::Krl;
  std::string name = "lamina";  ///< unless `robot_program.name` says otherwise
  RobotProgramSettings settings;
};

/// A toolpath as a program of a robot whose language is not RAPID (docs/programs/robot-programs.md): the file
/// that is loaded first, then those that it runs, each within the limits of its controller. It is split where
/// the process is off.
///
/// An arm comes to where each file begins by a move of its joints. Moves are straight, at poses over the bed
/// [mm]; roles, beads and layers are reported in comments before the moves of each path. Without an arm the
/// first move is straight.
///
/// @param bed_from_part  where the part stands on the bed [mm]
/// @param robot  may be null
/// @throws InvalidInput if the toolpath holds no motion, or drops, events or process values without an
/// output;
///   a position, speed or value is one that the language cannot state. Names layer, path and waypoint.
/// @throws Unreachable if the joints have faults, or the arm cannot stand where it is to start
/// @throws InvalidConfig if a setting cannot be, the controller cannot have the program's name, a run is
/// longer
///   than a file may be, or all files are larger than the controller's memory
std::vector<RobotFile> robotProgram(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                                    const RobotProgramRequest& request, const RobotMotion* robot = nullptr);

}  // namespace lamina
