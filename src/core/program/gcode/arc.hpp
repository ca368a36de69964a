// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

enum class ArcDirection { Clockwise, CounterClockwise };

/// An arc about an axis of the machine, along which it may climb.
struct Arc {
  Point3 start = Point3::Zero();   ///< [mm]
  Point3 end = Point3::Zero();     ///< [mm]; where the start is, it is a full circle
  Point3 centre = Point3::Zero();  ///< [mm]; what it holds along the axis does not matter
  int axis = 2;                    ///< 0, 1, 2 for x, y, z
  ArcDirection direction = ArcDirection::CounterClockwise;  ///< seen against the axis
};

/// Ends of the chords that follow the arc within the tolerance, the last being the end itself. Where start
/// and end are not equally far from the centre, the radius changes evenly.
/// @param chord_tolerance_mm  greatest distance between chord and arc, positive
std::vector<Point3> flatten(const Arc& arc, double chord_tolerance_mm);

/// The centre of an arc of the radius between two points: of its two arcs the shorter if the radius is
/// positive, the longer if it is negative.
/// @throws InvalidInput if the points are equal, or further apart than two radii (by more than rounding)
Point3 centreOfRadius(const Arc& arc, double radius_mm);

}  // namespace lamina
