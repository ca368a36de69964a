// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/gcode_rewrite/space_map.hpp"

namespace lamina {

/// Transformation of the points of a sliced program to points on the machine.
struct PointTransform {
  const SpaceMap& map;
  /// Map from positions over the bed to the machine's coordinates, if these differ.
  const SpaceMap* axes = nullptr;
  Point3 shift = Point3::Zero();  ///< shift added after the map [mm]

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

/// Divides straight motions so finely that at the quarter points no chord is farther from its mapped line
/// than the tolerance.
/// @param ends  ends of successive motions, as sliced
/// @return these ends, and the points in between
std::vector<Point3> divided(const Point3& start, const std::vector<Point3>& ends,
                            const PointTransform& transform, double tolerance_mm);

}  // namespace lamina
