// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"
#include "streaming/firmware/grbl/grbl_words.hpp"

namespace lamina {

/// The position to which a program leads the machine, axis by axis, in work coordinates. An axis is known if
/// it was moved to an absolute position after the last change of coordinates.
class ExpectedPosition {
 public:
  /// @param modes  answer to `$G`; if empty no axis is ever known
  explicit ExpectedPosition(std::string_view modes);

  /// Follows a line of the program that was sent.
  void follow(std::string_view command);

  /// The position axis by axis [mm]; none where unknown.
  const std::array<std::optional<double>, 3>& places() const { return axes_; }
  /// The largest distance of a known axis from its position [mm]; none if no axis is known.
  /// @param work  position of the machine [mm]
  std::optional<double> distanceFrom(const GrblAxes& work) const;

  /// How the machine's position contradicts the expected one, as "X is 3.000 mm; expected 4.000 mm"; empty if
  /// it agrees.
  /// @param work  position of the machine [mm]
  std::string contradictionBy(const GrblAxes& work) const;

 private:
  /// What a line states besides its motion.
  struct Line {
    bool moves_along_words = true;
    bool sets_words = false;  ///< G92
  };

  void giveUp();
  void forget() { axes_ = {}; }
  bool setMode(int tenfold);
  void onCommand(int tenfold, Line& line);
  void onMotion(const GrblWords& words, const Line& line);

  std::array<std::optional<double>, 3> axes_;  ///< [mm]
  bool is_followed_ = false;
  bool is_absolute_ = true;
  bool moves_ = true;  ///< whether a motion mode is active
  double unit_mm_ = 1.0;
  int work_system_ = 540;  ///< ten times the number of the G code: 540 for G54
};

}  // namespace lamina
