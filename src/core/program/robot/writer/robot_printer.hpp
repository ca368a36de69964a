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

/// Memory of a controller that a file takes.
struct RobotFileSize {
  std::size_t lines = 0;
  std::size_t points = 0;
};

/// Contents of the head of a file.
struct RobotFileHead {
  std::string name;                ///< name of the program in the file
  std::vector<std::string> notes;  ///< notes on the whole program; in its first file only
  std::string part_name;
};

/// Properties of the robot that a file is printed for.
struct RobotSite {
  RobotProgramSettings settings;
  std::optional<ArmCell> cell;  ///< cell over the controller's base; nothing if no arm is known
  ControllerMap map;
  std::vector<JointKind> external;  ///< kinds of the external axes, in their order

  /// Whether programs run dry at a speed of their own.
  bool hasDrySpeed() const { return settings.dry_speed_percent < 100.0; }
};

/// Prints statements in a language, as one file or a pair of files.
class RobotPrinter {
 public:
  virtual ~RobotPrinter() = default;
  /// Appends a statement.
  /// @throws InvalidInput if the language cannot express a value
  virtual void print(const RobotStatement& statement) = 0;
  virtual RobotFileSize size() const = 0;
  /// The text printed so far; the file to be loaded comes first.
  virtual std::vector<RobotFile> files(const RobotFileHead& head) const = 0;
};

/// Limits of a file in a language, on any controller.
struct RobotLimits {
  std::size_t lines = std::numeric_limits<std::size_t>::max();
  std::size_t points = std::numeric_limits<std::size_t>::max();
  std::size_t bytes_in_all = std::numeric_limits<std::size_t>::max();
};

/// Properties of a language that the writer needs.
struct RobotDialect {
  RobotLanguage language = RobotLanguage::Krl;
  RobotLimits limits;
  std::string limit_key;  ///< setting that holds the limits, for errors
  /// Whether a file can run others; otherwise files are run one after the other by hand.
  bool has_calls = true;
  std::unique_ptr<RobotPrinter> (*open)(const RobotSite& site) = nullptr;
  /// The name of a program in the form of the language, made from the requested one.
  /// @throws InvalidConfig if no name can be made
  std::string (*name)(const std::string& asked, const RobotProgramSettings& settings) = nullptr;
};

RobotDialect robotDialect(RobotLanguage language, const RobotProgramSettings& settings);

/// How the controller of a language counts joints.
ControllerMap controllerMap(RobotLanguage language, const RobotProgramSettings& settings);

/// Refuses a name unless it consists of ASCII letters, digits and underscores, begins with a letter, and has
/// at most `longest` characters.
/// @throws InvalidConfig naming robot_program.name
void requireProgramName(const std::string& name, std::size_t longest, RobotLanguage language);

/// Refuses a name that the language reserves, in any case.
/// @param reserved  names in lower case
/// @throws InvalidConfig naming robot_program.name
void requireFreeName(const std::string& name, const std::vector<std::string_view>& reserved,
                     RobotLanguage language);

/// Refuses a dry run at a speed of its own in a language whose moves state speeds as plain numbers: only an
/// override of the controller could change these speeds, and it would outlast the program.
/// @throws InvalidConfig
void requireNoDrySpeed(const RobotProgramSettings& settings, RobotLanguage language);

/// Refuses a schedule of an arc that nobody has chosen: what a controller holds under a number is the
/// integrator's.
/// @param key  "robot_program.start_schedule"
/// @throws InvalidConfig if it is 0
void requireSchedule(const char* key, int schedule);

/// The same of both schedules of an arc, where arcs switch the process.
void requireSchedules(const ArcSettings& arc);

/// Refuses a coordinate of the nozzle or an external axis that, rounded, has more than the five digits before
/// the point that controllers hold.
/// @param unit  "mm", "deg"
/// @throws InvalidInput
void requireInFormat(double value, const char* unit, RobotLanguage language);

/// Refuses output 0 in a language that numbers outputs from 1.
/// @throws InvalidInput
void requireOutputNumber(int output, RobotLanguage language);

/// Why the controller takes points over a frame that stands still, for errors.
struct StandingFrame {
  std::string why;     ///< "fanuc.coordinated is false"
  std::string remedy;  ///< what is expected instead: "true"
};

/// Refuses a move over a bed that an axis has turned from where the joint is at zero, in a program whose
/// points the controller takes over a frame that stands still.
/// @param external  values of the axes, as the controller counts them
/// @throws InvalidInput
void requireHeldTable(const std::vector<double>& external, const RobotSite& site, const StandingFrame& frame);

/// A wait divided into waits of at most `longest_s`, to be written one after the other [s].
std::vector<double> waitParts(double duration_s, double longest_s);

/// The name with ASCII letters in upper case.
std::string upperCaseName(const std::string& name);

/// The text on one line, with a question mark for every character that is not printable ASCII.
std::string plainText(const std::string& text);

}  // namespace lamina
