// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A plane face of a convex hull.
struct HullFace {
  Point3 normal = Point3::Zero();  ///< outwards, of unit length
  double area_mm2 = 0.0;
};

/// Faces of the convex hull of points [Barber1996], the largest first. Triangles whose planes differ by no
/// more than 0.01 deg are one face; points lie on a face if they are within 1e-9 times the extent of all
/// points from it. Time is about n log n in the number of points.
/// @return none if all points lie in one plane
std::vector<HullFace> hullFaces(const std::vector<Point3>& points);

}  // namespace lamina
