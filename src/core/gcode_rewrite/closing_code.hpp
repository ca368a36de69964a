// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "gcode_rewrite/program_tracker.hpp"
#include "lamina/gcode_rewrite/rewrite_settings.hpp"

namespace lamina {

/// Keeps the nozzle away from the part once it is printed, and writes the final move and the user's end code
/// once each. Each is written as late as it can still take effect: the move before motors are switched off or
/// the program ends, the end code before the program ends.
class ClosingCode {
 public:
  /// @param clear_z  height at or above everything deposited [mm]; nothing if z is not up
  ClosingCode(const RewriteSettings& settings, std::optional<double> clear_z, int decimals);

  /// To be called where the part ends.
  /// @param z  height of the nozzle over the bed at that point [mm]
  void leavePartAt(double z);
  /// To be called before each line after the last deposition is written.
  /// @throws InvalidProgram naming the line if the program's own end code moves down into the part
  void beforeLine(const ProgramTracker& tracker, std::string& out);
  void atEnd(const ProgramTracker& tracker, std::string& out);

 private:
  void appendMove(const ProgramTracker& tracker, std::string& out);
  void requireClear(const ProgramTracker& tracker) const;
  void appendEndCode(std::string& out);

  std::optional<double> clear_z_;
  /// Lift before the first motion of the end code, as leaning layers may end anywhere beside the part.
  std::string lift_;
  std::string move_;
  std::string end_code_;
};

/// The code with a line feed at its end; empty if the code is empty.
std::string wholeLines(std::string code);

}  // namespace lamina
