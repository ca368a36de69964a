// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/gcode_rewrite/space_map.hpp"

namespace lamina {

/// Where points of the sliced program come on the machine.
struct PointTransform {
  const SpaceMap& map;
  const SpaceMap* axes = nullptr;  ///< from places over the bed to the machine's coordinates, if they differ
  Point3 shift = Point3::Zero();   ///< after the map [mm]

  Point3 overBed(const Point3& point) const { return map.map(point) + shift; }
  Point3 coordinates(const Point3& over_bed) const {
    return axes != nullptr ? axes->map(over_bed) : over_bed;
  }
  bool keepsLines() const {
    return map.kind() != MapKind::Curved && (axes == nullptr || axes->kind() != MapKind::Curved);
  }
  bool keepsLengths() const {
    return map.kind() == MapKind::Isometry && (axes == nullptr || axes->kind() == MapKind::Isometry);
  }
};

/// Divides each straight motion so finely that no chord is further off its mapped line than the tolerance at
/// the quarter points.
/// @param ends  of motions one after the other from the start, as sliced
/// @return the ends and the points between
std::vector<Point3> divided(const Point3& start, const std::vector<Point3>& ends,
                            const PointTransform& transform, double tolerance_mm);

}  // namespace lamina
