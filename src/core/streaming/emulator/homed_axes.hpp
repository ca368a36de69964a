// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "lamina/program/gcode/gcode_reader.hpp"

namespace lamina {

/// The axes of a machine that are homed: X, Y and Z, by their numbers.
class HomedAxes {
 public:
  void home(std::size_t axis) { is_homed_.at(axis) = true; }
  void forget() { is_homed_ = {}; }
  /// States that motors are switched off.
  /// @param words  the rest of the command; if it names no motor, all are switched off
  void release(std::string_view words) {
    const bool is_all = words.find_first_of("XYZE") == std::string_view::npos;
    for (std::size_t axis = 0; axis < kLetters.size(); ++axis)
      if (is_all || words.find(kLetters[axis]) != std::string_view::npos) is_homed_[axis] = false;
  }

  bool areAll() const { return is_homed_[0] && is_homed_[1] && is_homed_[2]; }
  /// The letters of the axes that are homed.
  std::string letters() const {
    std::string letters;
    for (std::size_t axis = 0; axis < kLetters.size(); ++axis)
      if (is_homed_[axis]) letters += kLetters[axis];
    return letters;
  }
  /// Letters of the axes that a motion needs and that are not homed.
  std::string lettersMissing(const GcodeMotion& motion) const {
    std::string letters;
    for (std::size_t axis = 0; axis < kLetters.size(); ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      if (!is_homed_[axis] && motion.end[i] != motion.start[i]) letters += kLetters[axis];
    }
    return letters;
  }

 private:
  static constexpr std::array<char, 3> kLetters = {'X', 'Y', 'Z'};

  std::array<bool, 3> is_homed_{};
};

}  // namespace lamina
