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

/// Name, language and settings of a program.
struct RobotProgramRequest {
  RobotLanguage language = RobotLanguage::Krl;
  std::string name = "lamina";  ///< used unless `robot_program.name` is set
  RobotProgramSettings settings;
};

/// A toolpath as a program for a robot whose language is not RAPID (docs/programs/robot-programs.md): first
/// the file to be loaded, then the files that it runs, each within the limits of the controller. The program
/// is divided where the process is off; within a run only if `may_cut` allows it.
///
/// If an arm is given, each file begins with a joint move to its first pose. All other moves are straight,
/// between poses over the bed [mm]. Comments before the moves of each path state roles, beads and layers.
/// Without an arm the first move is straight, too.
///
/// @param bed_from_part  pose of the part on the bed [mm]
/// @param robot  its arm and joints; may be null
/// @throws InvalidInput naming layer, path and waypoint, if the toolpath holds no motion, if it holds drops,
///   events other than dwells, or process values without an output, or if the language cannot state a
///   position, speed or value
/// @throws Unreachable if the joints have faults, or the arm cannot reach where the program starts or ends,
///   `approach_mm` off the part
/// @throws InvalidConfig if a setting is invalid, the controller does not allow the program's name, a run is
///   longer than a file may be, or all files together are larger than the controller's memory
std::vector<RobotFile> robotProgram(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                                    const RobotProgramRequest& request, const RobotMotion* robot = nullptr);

/// Checks what is known of a program before its toolpath is known: settings, name, and whether the language
/// can state the arm's external axes.
/// @throws InvalidInput, InvalidConfig as `robotProgram`
void requireWritable(const RobotProgramRequest& request, const KinematicModel& arm);

}  // namespace lamina
