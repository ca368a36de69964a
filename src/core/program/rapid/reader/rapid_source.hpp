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
#include "program/rapid/reader/rapid_cursor.hpp"

namespace lamina {

/// A move instruction with everything it names looked up.
struct RapidMove {
  Point3 point = Point3::Zero();  ///< [mm, work object]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  double feed_mm_s = 0.0;
};

enum class RapidAction : std::uint8_t {
  Move,      ///< `index` into the moves
  Set,       ///< of an output
  Reset,     ///< of an output
  Call,      ///< `index` into the names that are called
  Preparing  ///< nothing that moves or deposits
};

struct RapidStatement {
  RapidAction action = RapidAction::Preparing;
  std::size_t line = 0;
  std::size_t index = 0;
};

struct RapidProcedure {
  std::size_t module = 0;              ///< that it stands in
  std::vector<RapidComment> comments;  ///< between the procedure before and this one
  std::vector<RapidStatement> statements;
};

/// A robtarget.
struct RapidTarget {
  Point3 point = Point3::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

/// All modules of a program. Names are lower case.
struct RapidSource {
  std::map<std::string, double> numbers;
  std::map<std::string, double> speeds;  ///< [mm/s]
  std::map<std::string, RapidTarget> targets;
  std::set<std::string> names;  ///< of all data
  std::string work_object;      ///< that of the first move
  std::vector<RapidMove> moves;
  std::vector<std::string> called;
  std::map<std::string, RapidProcedure> procedures;
  std::vector<RapidComment> head;  ///< comments before the first procedure of the first module
  std::vector<std::string> files;  ///< names of the modules' files
};

/// Adds a module.
/// @throws InvalidProgram naming file and line
void readRapidModule(RapidCursor& cursor, RapidSource& source);

/// A data declaration, after its first word; each kind of data that the writer declares.
void readRapidDeclaration(RapidCursor& cursor, RapidSource& source);

/// A robtarget's value: [[x,y,z],[w,x,y,z],[configuration],[external axes]].
RapidTarget readRapidTarget(RapidCursor& cursor);

/// One statement of a procedure, if it does not end here.
void readRapidStatement(RapidCursor& cursor, RapidSource& source, RapidProcedure& procedure);

}  // namespace lamina
