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

/// Faces of the convex hull of points [Barber1996], the largest first: triangles in one plane, within 0.01
/// deg, are one. Points within 1e-9 of the size of all from a face lie on it. About n log n in points.
/// @return none if all points lie in one plane
std::vector<HullFace> hullFaces(const std::vector<Point3>& points);

}  // namespace lamina
