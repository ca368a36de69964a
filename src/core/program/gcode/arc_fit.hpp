// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "program/gcode/arc.hpp"

namespace lamina {

/// An arc that stands for a run of chords.
struct FittedArc {
  std::size_t last = 0;            ///< index of the point at which it ends
  Point2 centre = Point2::Zero();  ///< [mm]
  double sweep_rad = 0.0;
  ArcDirection direction = ArcDirection::CounterClockwise;
};

/// The longest arc from a point on: it ends at a later one, through both ends goes the circle that fits the
/// points between them best by least squares of their powers, and no point or middle of a chord is further
/// from it than the tolerance. It has 4 points or more, sweeps more than 5 and at most 180 deg, and its
/// radius lies in 0.5 to 2000 mm. None if there is no such arc. Found by doubling and halving the number of
/// chords: n log n in the chords tried.
/// @param last  the arc ends there at the latest
std::optional<FittedArc> longestArc(const std::vector<Point2>& points, std::size_t first, std::size_t last,
                                    double tolerance_mm);

}  // namespace lamina
