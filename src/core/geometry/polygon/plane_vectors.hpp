// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Cross product of two vectors; positive if b is to the left of a.
inline double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Twice the signed area of the triangle of three points; positive if the point is to the left of the line
/// from a to b.
inline double side(const Point2& a, const Point2& b, const Point2& point) { return cross(b - a, point - a); }

/// The vector turned left by a right angle. Along the outline of a region it points to the material.
inline Point2 leftOf(const Point2& direction) { return {-direction.y(), direction.x()}; }
inline Point2 rightOf(const Point2& direction) { return {direction.y(), -direction.x()}; }

/// Angle from one direction to the other [rad], positive to the left.
inline double turn(const Point2& from, const Point2& to) { return std::atan2(cross(from, to), from.dot(to)); }

/// The point of the segment from a to b that is nearest to another point; a if the segment has no length.
inline Point2 nearestOnSegment(const Point2& a, const Point2& b, const Point2& point) {
  const Point2 along = b - a;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((point - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return a + share * along;
}

/// Whether the segment from a to b crosses that from c to d.
inline bool areCrossing(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return (side(a, b, c) > 0.0) != (side(a, b, d) > 0.0) && (side(c, d, a) > 0.0) != (side(c, d, b) > 0.0);
}

}  // namespace lamina
