// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "gcode_rewrite/program_tracker.hpp"
#include "lamina/gcode_rewrite/rewrite_settings.hpp"

namespace lamina {

/// Keeps the nozzle clear of the part once it is printed, and writes the final move and the user's end code
/// once each, as late as they still do what they are for: the move before motors or program end, the end code
/// before the program ends.
class ClosingCode {
 public:
  /// @param clear_z  no lower than anything deposited [mm]; nothing where z is not up
  ClosingCode(const RewriteSettings& settings, std::optional<double> clear_z, int decimals);

  /// Call where the part ends.
  /// @param z  of the nozzle there, over the bed [mm]
  void leavePartAt(double z);
  /// Call before each line after the last deposition is written.
  /// @throws InvalidProgram naming the line where the program's own end code goes down into the part
  void beforeLine(const ProgramTracker& tracker, std::string& out);
  void atEnd(const ProgramTracker& tracker, std::string& out);

 private:
  void appendMove(const ProgramTracker& tracker, std::string& out);
  void requireClear(const ProgramTracker& tracker) const;
  void appendEndCode(std::string& out);

  std::optional<double> clear_z_;
  std::string lift_;  ///< before the end code moves: layers that lean end anywhere beside the part
  std::string move_;
  std::string end_code_;
};

/// The code, ended by a line feed unless it is empty.
std::string wholeLines(std::string code);

}  // namespace lamina
