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
#include "program/rapid/reader/rapid_cursor.hpp"

namespace lamina {

/// A robtarget.
struct RapidTarget {
  Point3 point = Point3::Zero();  ///< [mm, work object]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  AbbConfiguration configuration;
  std::vector<double> external;  ///< axes that are there [mm, deg]
};

/// What a move does to the arc.
enum class RapidArc : std::uint8_t { None, Start, On, End };

/// A move instruction with everything it names looked up.
struct RapidMove {
  RapidTarget target;
  double feed_mm_s = 0.0;
  std::size_t line = 0;
  bool is_heeded = false;  ///< its configuration: under ConfL\On
  RapidArc arc = RapidArc::None;
};

/// A jointtarget.
struct RapidJoints {
  std::vector<double> arm_deg;
  std::vector<double> external;  ///< axes that are there [mm, deg]
};

/// What a module declares of its cell.
struct RapidTool {
  Eigen::Isometry3d flange_from_tip = Eigen::Isometry3d::Identity();  ///< [mm]
};
struct RapidWorkObject {
  bool is_fixed = true;                                      ///< no mechanical unit carries it
  std::string carrier;                                       ///< the unit's name
  Eigen::Isometry3d user = Eigen::Isometry3d::Identity();    ///< [mm]
  Eigen::Isometry3d object = Eigen::Isometry3d::Identity();  ///< over it [mm]
};

enum class RapidAction : std::uint8_t {
  Move,        ///< `index` into the moves
  MoveJoints,  ///< `index` into the joint moves
  Heed,        ///< configurations of linear moves, if `index` is 1
  Set,         ///< of an output
  Reset,       ///< of an output
  Wait,        ///< that is the toolpath's, `duration_s`
  Call,        ///< `index` into the names that are called
  Preparing    ///< nothing that moves or deposits
};

struct RapidStatement {
  RapidAction action = RapidAction::Preparing;
  std::size_t line = 0;
  std::size_t index = 0;
  double duration_s = 0.0;
};

struct RapidProcedure {
  std::size_t module = 0;              ///< that it stands in
  std::vector<RapidComment> comments;  ///< between the procedure before and this one
  std::vector<RapidStatement> statements;
};

/// All modules of a program. Names are lower case.
struct RapidSource {
  std::map<std::string, double> numbers;
  std::map<std::string, double> speeds;  ///< [mm/s]
  std::map<std::string, RapidTarget> targets;
  std::set<std::string> names;  ///< of all data
  std::string work_object;      ///< that of the first move
  std::string tool;             ///< that of the first move
  std::map<std::string, RapidTool> tools;
  std::map<std::string, RapidWorkObject> work_objects;
  std::vector<RapidMove> moves;
  std::vector<RapidJoints> joint_moves;
  std::vector<std::string> called;
  std::map<std::string, RapidProcedure> procedures;
  std::vector<RapidComment> head;  ///< comments before the first procedure of the first module
  std::vector<std::string> files;  ///< names of the modules' files
  std::set<std::string> process;   ///< statements that switch it, wait for it, or name its data
};

/// Adds a module.
/// @throws InvalidProgram naming file and line
void readRapidModule(RapidCursor& cursor, RapidSource& source);

/// A data declaration, after its first word; each kind of data that the writer declares.
void readRapidDeclaration(RapidCursor& cursor, RapidSource& source);

/// A robtarget's value: [[x,y,z],[w,x,y,z],[configuration],[external axes]].
RapidTarget readRapidTarget(RapidCursor& cursor);

/// A jointtarget's value: [[joints 1 to 6],[external axes]].
RapidJoints readRapidJoints(RapidCursor& cursor);

/// One statement of a procedure, if it does not end here.
void readRapidStatement(RapidCursor& cursor, RapidSource& source, RapidProcedure& procedure);

}  // namespace lamina
