// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/arm/abb_configuration.hpp"
#include "lamina/program/rapid/rapid_settings.hpp"
#include "program/rapid/reader/rapid_cursor.hpp"

namespace lamina {

constexpr double kNoRapidAxis = 9e9;  ///< the value of an external axis that is not there

/// Value of a robtarget.
struct RapidTarget {
  Point3 point = Point3::Zero();  ///< [mm, work object]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  AbbConfiguration configuration;
  /// Values of the external axes up to the last that is there [mm, deg]; `kNoRapidAxis` of others.
  std::vector<double> external;
};

/// Effect of a move on the arc.
enum class RapidArc : std::uint8_t { None, Start, On, End };

/// A move instruction with the data it names already looked up.
struct RapidMove {
  RapidTarget target;
  double feed_mm_s = 0.0;
  std::size_t line = 0;
  std::size_t module = 0;  ///< index of the file of the procedure that runs it
  bool is_heeded = false;  ///< whether its configuration is obeyed: it is executed under ConfL\On
  RapidArc arc = RapidArc::None;
  std::vector<std::string> triggers;  ///< names of the triggers that act during the move
};

/// Value of a jointtarget.
struct RapidJoints {
  std::vector<double> arm_deg;
  /// Values of the external axes up to the last that is there [mm, deg]; `kNoRapidAxis` of others.
  std::vector<double> external;
};

/// Value of a tooldata, as far as it is needed.
struct RapidTool {
  Eigen::Isometry3d flange_from_tip = Eigen::Isometry3d::Identity();  ///< [mm]
};
struct RapidWorkObject {
  bool is_fixed = true;  ///< whether no mechanical unit carries it
  std::string carrier;   ///< name of the unit that carries it; empty if fixed
  Eigen::Isometry3d user = Eigen::Isometry3d::Identity();    ///< [mm]
  Eigen::Isometry3d object = Eigen::Isometry3d::Identity();  ///< relative to the user frame [mm]
};

/// An analogue output that is set, at once or by a trigger.
struct RapidLevelChange {
  std::string signal;
  double value = 0.0;
  std::string trigger;  ///< name of the trigger; empty if the output is set at once
};

enum class RapidAction : std::uint8_t {
  Move,        ///< the move with this `index`
  MoveJoints,  ///< the joint move with this `index`
  Heed,        ///< switches the obeying of configurations of linear moves on if `index` is 1, off if 0
  Level,       ///< sets the level with this `index`, or has its trigger do so
  Set,         ///< sets an output
  Reset,       ///< resets an output
  Wait,        ///< a wait of the toolpath, of `duration_s`
  Call,        ///< calls the procedure whose name has this `index`
  Preparing    ///< anything that neither moves nor deposits
};

struct RapidStatement {
  RapidAction action = RapidAction::Preparing;
  std::size_t line = 0;
  std::size_t index = 0;
  double duration_s = 0.0;
};

struct RapidProcedure {
  std::size_t module = 0;              ///< index of its module
  std::vector<RapidComment> comments;  ///< comments between the procedure before and this one
  std::vector<RapidStatement> statements;
};

/// All modules of a program. Names are lower case.
struct RapidSource {
  std::map<std::string, double> numbers;
  std::map<std::string, double> speeds;  ///< [mm/s]
  std::map<std::string, RapidTarget> targets;
  std::set<std::string> names;  ///< names of all data
  std::string work_object;      ///< work object of the first move
  std::string tool;             ///< tool of the first move
  std::map<std::string, RapidTool> tools;
  std::map<std::string, RapidWorkObject> work_objects;
  std::vector<RapidMove> moves;
  std::vector<RapidJoints> joint_moves;
  std::vector<RapidLevelChange> level_changes;
  std::vector<RapidLevel> levels;        ///< of the notes; names of outputs in lower case
  std::vector<RapidExternal> externals;  ///< of the notes
  std::vector<std::string> called;
  std::map<std::string, RapidProcedure> procedures;
  std::vector<RapidComment> head;  ///< comments before the first procedure of the first module
  std::vector<std::string> files;  ///< names of the modules' files
  /// Names of statements that switch the process, wait for it, or name its data.
  std::set<std::string> process;
  bool is_conditional = false;  ///< whether the next statement stands under the condition of a dry run
  bool is_dry = false;          ///< whether the next statement belongs to what a dry run does instead
};

/// Reads a module and adds it to the source.
/// @throws InvalidProgram naming file and line
void readRapidModule(RapidCursor& cursor, RapidSource& source);

/// Reads a data declaration whose first word has been read, of any kind that the writer declares.
void readRapidDeclaration(RapidCursor& cursor, RapidSource& source);

/// Reads the value of a robtarget: [[x,y,z],[w,x,y,z],[configuration],[external axes]].
RapidTarget readRapidTarget(RapidCursor& cursor);

/// Reads the value of a jointtarget: [[joints 1 to 6],[external axes]].
RapidJoints readRapidJoints(RapidCursor& cursor);

/// Reads one statement of a procedure, unless the procedure ends here.
void readRapidStatement(RapidCursor& cursor, RapidSource& source, RapidProcedure& procedure);

}  // namespace lamina
