// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

enum class ArcDirection { Clockwise, CounterClockwise };

/// A circular arc about a direction parallel to an axis of the machine; it may be a helix that climbs along
/// that axis.
struct Arc {
  Point3 start = Point3::Zero();   ///< [mm]
  Point3 end = Point3::Zero();     ///< [mm]; if equal to the start, the arc is a full circle
  Point3 centre = Point3::Zero();  ///< [mm]; its coordinate along the axis is ignored
  int axis = 2;                    ///< 0, 1, 2 for x, y, z
  ArcDirection direction = ArcDirection::CounterClockwise;  ///< seen against the axis
};

/// Ends of the chords that replace an arc within the tolerance; the last one is exactly the end of the arc.
/// If start and end have different distances from the centre, the radius changes evenly along the arc.
/// @param chord_tolerance_mm  greatest distance between chord and arc, positive
std::vector<Point3> flatten(const Arc& arc, double chord_tolerance_mm);

/// The centre of an arc with a given radius between two points. A positive radius denotes the shorter of the
/// two possible arcs, a negative one the longer.
/// @throws InvalidInput if the points are equal, or further apart than two radii (by more than rounding)
Point3 centreOfRadius(const Arc& arc, double radius_mm);

}  // namespace lamina
