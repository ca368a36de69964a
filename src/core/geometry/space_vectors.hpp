// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Angle between two directions of any lengths [rad], 0 to pi; 0 if one of them has no length.
inline double angleBetween(const Point3& a, const Point3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The rotation about a rotation vector, by the length of the vector [rad]; exactly the identity for length
/// 0.
inline Eigen::AngleAxisd turnBy(const Point3& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (angle == 0.0) return {0.0, Point3::UnitZ()};
  return {angle, rotation_vector / angle};
}

/// Distance of a point from the segment from a to b.
inline double distanceToSegment(const Point3& point, const Point3& a, const Point3& b) {
  const Point3 along = b - a;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (point - a - share * along).norm();
}

}  // namespace lamina
