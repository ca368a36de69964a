// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lamina/kinematics/arm/arm_cell.hpp"
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

/// A statement that sets what the flange carries.
struct StatedTool {
  ToolStatement what;
  std::string place;  ///< file and line, for errors
};

/// What the notes at the beginning of a program state.
struct RobotHeadNotes {
  std::optional<Eigen::Isometry3d> tool;  ///< pose of the nozzle over the flange [mm]
  std::optional<Eigen::Isometry3d> bed;   ///< pose of the bed over what carries it [mm]
  std::optional<ToolLoad> load;           ///< what the flange carries
  std::vector<StatedTool> stated_tools;   ///< of statements besides the notes
  /// Place of the first move of the tip before any tool is stated, in a language without tools by number;
  /// empty if there is none.
  std::string untold_tool;
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
  std::size_t file = 0;    ///< index in the files of the program
  double feed_mm_s = 0.0;  ///< as stated
};

/// A move of an approach or a retract.
struct RunWay {
  std::size_t before = 0;                                  ///< number of moves of the part before it
  std::optional<ControllerJoints> joints;                  ///< of a joint move
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< to which a straight move leads [mm, bed]
  std::vector<double> external;                            ///< of a straight move [mm, deg]
  double feed_mm_s = 0.0;                                  ///< of a straight move
  std::size_t line = 0;
};

/// A program in the order in which it is run.
struct RobotRunning {
  AssembledProgram program;
  std::vector<RunMove> moves;  ///< by the index of the move in the stations
  std::vector<RunWay> ways;    ///< in the order in which they are run
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
