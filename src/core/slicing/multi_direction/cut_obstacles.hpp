// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace lamina {

/// What keeps a part from being cut across a direction: a cut would free too little surface (`Gain`), would
/// have head or plane in the bed (`Bed`), would cut off a piece that lies on too little (`Base`) or leave a
/// rest that does not stand (`Rest`), or costs more than it frees (`Price`).
enum class DirectionObstacle : std::uint8_t { Gain, Bed, Base, Rest, Price };

/// Number of directions by obstacle, and the bounds.
struct CutObstacles {
  std::array<std::size_t, 5> directions{};  ///< by `DirectionObstacle`
  double least_gain_mm2 = 0.0;              ///< least surface that a cut has to free
  double least_base_mm2 = 0.0;              ///< least area that a piece has to lie on
  /// Least height of the tip above the bed at which the head does not touch the bed, over the directions of
  /// `Bed`.
  double least_tip_mm = std::numeric_limits<double>::infinity();

  std::size_t count() const;
  std::size_t of(DirectionObstacle obstacle) const { return directions[static_cast<std::size_t>(obstacle)]; }
};

/// "no further cut across 321 directions: across 300 the head would be in the bed, from which its tip has to
/// stay 212 mm or more, in a part 50 mm high; across 21 a cut would free less than 27.5 mm²"
std::string textOf(const CutObstacles& obstacles, double part_height_mm);

}  // namespace lamina
