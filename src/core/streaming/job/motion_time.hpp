// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "lamina/program/gcode/gcode_reader.hpp"

namespace lamina {

/// How long the motions of a program take at their feeds, line by line, without acceleration: never more than
/// the machine needs. Where the program cannot be read as Marlin's G-code, nothing is said of what follows.
class MotionTime {
 public:
  MotionTime();

  /// [s] of the motions that the next command of the program asks for; 0 if it asks for none.
  double secondsOf(std::string_view command);

 private:
  double seconds_ = 0.0;
  bool is_readable_ = true;
  GcodeReader reader_;
};

}  // namespace lamina
