// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/job/plate/plate_settings.hpp"

namespace lamina {

/// What a part covers of the bed.
struct Footprint {
  std::string name;             ///< for messages
  Polygon hull;                 ///< convex, the middle of its box at the origin
  std::optional<Point2> at_mm;  ///< where it has to stand
};

/// Where a part stands.
struct PlatePlace {
  Point2 at_mm = Point2::Zero();  ///< of the middle of the box of the part as it is turned [bed frame]
  int eighths = 0;                ///< of a turn about z, by which the part is turned besides
};

/// Places of parts on a bed. Those that have to stand somewhere stand there, and the others keep
/// `plate.spacing_mm` from them and from each other. Without any of the former the middle of all comes over
/// that of the bed. Deterministic.
///
/// Rows: boxes from left to right in the order given; a row begins where the deepest part of the row before
/// ends. Pack: the largest first, each as far down, then as far to the left as it goes, in that of eight
/// turns in which it ends lowest. A footprint is there the smallest polygon around it whose edges have 16
/// fixed directions, so that the distances of two along these decide whether they overlap.
///
/// @param bed  room for the footprints
/// @return as many as footprints
/// @throws Unreachable naming the first that finds no room
std::vector<PlatePlace> arranged(const std::vector<Footprint>& footprints, const Box2& bed,
                                 const PlateSettings& settings);

}  // namespace lamina
