// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/spatial/nearest_triangle.hpp"

namespace lamina {

/// A place on a curve: on the segment from point `segment` to the next one.
struct CurvePlace {
  std::size_t segment = 0;
  double fraction = 0.0;
  Point3 point = Point3::Zero();  ///< [mm]
  double distance_mm = 0.0;       ///< from the queried point
};

/// Finds the place of a curve that is nearest to a point, in logarithmic time.
class CurvePlaces {
 public:
  /// @param points  of the curve, two or more
  CurvePlaces(const std::vector<Point3>& points, bool is_closed);
  CurvePlaces(const CurvePlaces&) = delete;
  CurvePlaces& operator=(const CurvePlaces&) = delete;

  CurvePlace nearest(const Point3& point) const;

 private:
  Mesh segments_;  // as triangles whose last two corners coincide
  NearestTriangle tree_;
};

/// The direction at a place of a curve, of unit length: interpolated between those of the segment's ends.
Point3 directionAt(const std::vector<Point3>& directions, const CurvePlace& place);

}  // namespace lamina
