// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/program/gcode/gcode_line.hpp"
#include "lamina/program/gcode/gcode_reader.hpp"

namespace lamina {

/// The state of a machine after a program was run up to a line: modes, temperatures, position, and the
/// bounding box of what was deposited. Lengths are in mm, in the machine's coordinates.
class ProgramState {
 public:
  ProgramState();
  ProgramState(const ProgramState&) = delete;
  ProgramState& operator=(const ProgramState&) = delete;

  /// Runs the next command.
  /// @throws InvalidProgram
  void run(const std::string& command);

  double unit_mm = 1.0;
  bool is_relative = false;
  bool is_filament_relative = false;
  double feed_mm_min = 1500.0;
  bool is_rapid = false;  ///< whether the last motion was a G0
  int plane = 17;
  int tool = 0;
  double speed_percent = 100.0;
  std::string workplace;             ///< G54 to G59.3; empty for the default
  Point3 position = Point3::Zero();  ///< of the machine's axes
  Point3 shift = Point3::Zero();     ///< machine less program coordinates, as set by G92
  double filament_mm = 0.0;          ///< sum of E as the program counts it
  double retracted_mm = 0.0;         ///< filament retracted at present
  bool is_firmware_retracted = false;
  std::optional<double> bed_c;
  std::optional<double> chamber_c;
  std::map<int, double> nozzle_c;  ///< by tool
  /// For each thing that a command sets, the last such command.
  std::vector<std::pair<std::string, std::string>> remembered;
  /// Commands whose effect cannot be restored: the first of each kind.
  std::vector<std::string> not_reproduced;

  bool has_deposited = false;
  Point3 lowest = Point3::Zero();   ///< lower corner of the bounding box of what was deposited
  Point3 highest = Point3::Zero();  ///< upper corner of that box
  double deposited_length_mm = 0.0;

 private:
  void onMotion(const GcodeMotion& motion);
  void runWords(const GcodeLine& line);
  void setPosition(const std::map<char, std::optional<double>>& words);
  void runOther(const std::string& command);
  bool runTemperature(int code, const std::string& command);
  void remember(const std::string& key, const std::string& command);

  GcodeReader reader_;
  GcodeLineParser parser_;
  double pushed_mm_ = 0.0;  ///< total of filament extruded
  double reached_mm_ = 0.0;
  std::size_t line_ = 0;
};

}  // namespace lamina
