// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/job/plate/plate_settings.hpp"

namespace lamina {

/// Area of the bed that a part covers.
struct Footprint {
  std::string name;             ///< for messages
  Polygon hull;                 ///< convex, with the middle of its bounding box at the origin
  std::optional<Point2> at_mm;  ///< position the part has to have; nothing if it is free
  double beside_mm = 0.0;       ///< by which brim or raft extend beyond the hull
  double cut_mm = 0.0;          ///< part of `beside_mm` that may be cut off at the bed's edge
};

/// Where a part stands.
struct PlatePlace {
  Point2 at_mm = Point2::Zero();  ///< middle of the bounding box of the turned part [bed frame]
  int eighths = 0;  ///< rotation about z in eighths of a full turn, besides that of its settings
};

/// Positions of parts on a bed. Parts with a position of their own keep it, and the others keep
/// `plate.spacing_mm` from them and from each other, between their brims or rafts if they have any. Brims
/// reach beyond the bed's edge, where they are cut off, if there is no other room. If no part has a position
/// of its own, the middle of all is put over the middle of the bed. Deterministic. Rows: bounding boxes from
/// left to right in the order given; each row begins beyond the deepest part of the row before. Pack: the
/// largest part first, each as far down, then as far to the left as possible, in the one of eight rotations
/// in which it ends lowest. For this a footprint is replaced by the smallest polygon around it with edges in
/// 16 fixed directions: distances along these directions decide whether two polygons overlap.
///
/// @param bed  area available to the footprints
/// @return one for each footprint
/// @throws Unreachable naming the first that does not fit
std::vector<PlatePlace> arranged(const std::vector<Footprint>& footprints, const Box2& bed,
                                 const PlateSettings& settings);

}  // namespace lamina
