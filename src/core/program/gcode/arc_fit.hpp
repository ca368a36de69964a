// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "program/gcode/arc.hpp"

namespace lamina {

/// An arc that replaces a sequence of chords.
struct FittedArc {
  std::size_t last = 0;            ///< index of the point at which the arc ends
  Point2 centre = Point2::Zero();  ///< [mm]
  double sweep_rad = 0.0;
  ArcDirection direction = ArcDirection::CounterClockwise;
};

/// The longest arc that begins at a point and replaces the chords from there to a later point. It passes
/// through both ends, and fits the points between them best by least squares of their powers. No point or
/// middle of a chord is farther from it than the tolerance. It replaces at least 4 points, sweeps more than 5
/// and at most 180 deg, and has a radius of 0.5 to 2000 mm. Nothing if there is no such arc. It is found by
/// doubling and halving the number of chords, in time of order n log n in the chords tried.
/// @param last  the last point at which the arc may end
std::optional<FittedArc> longestArc(const std::vector<Point2>& points, std::size_t first, std::size_t last,
                                    double tolerance_mm);

}  // namespace lamina
