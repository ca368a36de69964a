// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/robot/robot_program_settings.hpp"
#include "lamina/program/stated_equipment.hpp"
#include "lamina/program/stated_motion.hpp"
#include "program/robot/reader/path_assembly.hpp"
#include "program/robot/robot_cell.hpp"
#include "program/robot/robot_statement.hpp"

namespace lamina {

/// A file of a program as it is read.
struct RobotScriptFile {
  std::string name;
  std::vector<ReadStatement> statements;
};

/// What the notes at the beginning of a program state.
struct RobotHeadNotes {
  std::optional<Eigen::Isometry3d> tool;  ///< pose of the nozzle over the flange [mm]
  std::optional<Eigen::Isometry3d> bed;   ///< pose of the bed over what carries it [mm]
  bool is_bed_carried = false;
  int process_output = 1;
  std::vector<RobotLevel> levels;
  ControllerMap map;
  Eigen::Quaterniond bed_from_layers = Eigen::Quaterniond::Identity();
};

/// Properties of a move of the part that its toolpath does not hold.
struct RunMove {
  std::vector<double> external;  ///< [mm, deg]
  std::size_t line = 0;
  std::size_t file = 0;  ///< index in the files of the program
};

/// A program in the order in which it is run.
struct RobotRunning {
  AssembledProgram program;
  std::vector<RunMove> moves;  ///< by the index of the move in the stations
  std::optional<ControllerJoints> start;
  RobotHeadNotes head;
  StatedEquipment equipment;
  std::vector<std::string> files;  ///< names, in the order they are run
};

/// Runs the files one after the other.
/// @throws InvalidProgram naming file and line
RobotRunning runRobot(const std::vector<RobotScriptFile>& files, const std::string& note_mark);

/// Motion that a program states; see `readRobotMotion`.
StatedMotion robotMotionOf(RobotRunning running, const KinematicModel& arm);

}  // namespace lamina
