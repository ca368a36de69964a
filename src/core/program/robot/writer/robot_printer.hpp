// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/kinematics/arm/arm_cell.hpp"
#include "lamina/program/robot/robot_program_settings.hpp"
#include "lamina/program/robot/robot_writer.hpp"
#include "program/robot/robot_cell.hpp"
#include "program/robot/robot_statement.hpp"

namespace lamina {

/// How much of a controller's memory a file takes.
struct RobotFileSize {
  std::size_t lines = 0;
  std::size_t points = 0;
};

/// What stands at the head of a file.
struct RobotFileHead {
  std::string name;                ///< of the program in it
  std::vector<std::string> notes;  ///< of the whole program; in its first file
  std::string part_name;
};

/// What a file is printed for.
struct RobotSite {
  RobotProgramSettings settings;
  std::optional<ArmCell> cell;  ///< over the controller's base, where an arm is known
  ControllerMap map;
  std::vector<JointKind> external;  ///< kinds of the external axes, in their order
};

/// Makes one file, or a pair of files, of statements in a language.
class RobotPrinter {
 public:
  virtual ~RobotPrinter() = default;
  /// @throws InvalidInput if the language has no such value
  virtual void print(const RobotStatement& statement) = 0;
  virtual RobotFileSize size() const = 0;
  /// The text of what has been printed; the file that is loaded comes first.
  virtual std::vector<RobotFile> files(const RobotFileHead& head) const = 0;
};

/// What a file of a language may hold, on any controller.
struct RobotLimits {
  std::size_t lines = std::numeric_limits<std::size_t>::max();
  std::size_t points = std::numeric_limits<std::size_t>::max();
  std::size_t bytes_in_all = std::numeric_limits<std::size_t>::max();
};

/// What the writer has to know of a language.
struct RobotDialect {
  RobotLanguage language = RobotLanguage::Krl;
  RobotLimits limits;
  std::string limit_key;  ///< that sets them, for errors
  bool has_calls = true;  ///< a file runs others; else they are run one after the other
  std::unique_ptr<RobotPrinter> (*open)(const RobotSite& site) = nullptr;
  /// The name of a program as the language has it, of one asked for.
  /// @throws InvalidConfig if there can be none
  std::string (*name)(const std::string& asked, const RobotProgramSettings& settings) = nullptr;
};

RobotDialect robotDialect(RobotLanguage language, const RobotProgramSettings& settings);

/// How the controller of a language counts joints.
ControllerMap controllerMap(RobotLanguage language, const RobotProgramSettings& settings);

/// Letters, digits and underscores of ASCII, the first of them a letter, so many at most.
/// @throws InvalidConfig naming robot_program.name
void requireProgramName(const std::string& name, std::size_t longest, RobotLanguage language);

/// No word that the language has taken for itself, in capitals or not.
/// @param reserved  in small letters
/// @throws InvalidConfig naming robot_program.name
void requireFreeName(const std::string& name, const std::vector<std::string_view>& reserved,
                     RobotLanguage language);

/// Of a language that numbers outputs from 1.
/// @throws InvalidInput if it is 0
void requireOutputNumber(int output, RobotLanguage language);

/// A wait in parts that a language can state, one after the other [s].
std::vector<double> waitParts(double duration_s, double longest_s);

/// The name in capitals of ASCII.
std::string upperCaseName(const std::string& name);

/// Printable ASCII alone, on one line; question marks for the rest.
std::string plainText(const std::string& text);

}  // namespace lamina
