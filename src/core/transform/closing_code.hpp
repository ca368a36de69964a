// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/transform/transform_settings.hpp"
#include "transform/program_tracker.hpp"

namespace lamina {

/// Writes the final move and the user's end code once each, as late as they still do what they are for: the
/// move before motors or program end, the end code before the program ends.
class ClosingCode {
 public:
  /// @param clear_z  no lower than anything deposited [mm]
  ClosingCode(const TransformSettings& settings, double clear_z, int decimals);

  /// Call before each line after the last deposition is written.
  void beforeLine(const ProgramTracker& tracker, std::string& out);
  void atEnd(const ProgramTracker& tracker, std::string& out);

 private:
  void appendMove(const ProgramTracker& tracker, std::string& out);
  void appendEndCode(std::string& out);

  std::string move_;
  std::string end_code_;
};

/// The code, ended by a line feed unless it is empty.
std::string wholeLines(std::string code);

}  // namespace lamina
