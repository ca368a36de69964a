// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "lamina/program/gcode/gcode_reader.hpp"

namespace lamina {

/// Time of a program's motions at their feeds, line by line. Acceleration is neglected: the machine needs at
/// least this time. After a line that is not Marlin's G-code all times are 0.
class MotionTime {
 public:
  MotionTime();

  /// Time of the motions of the next command [s]; 0 if it has none.
  double secondsOf(std::string_view command);

 private:
  double seconds_ = 0.0;
  bool is_readable_ = true;
  GcodeReader reader_;
};

}  // namespace lamina
