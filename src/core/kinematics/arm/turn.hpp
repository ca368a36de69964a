// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// An angle as its cosine and sine.
using Turn = Point2;

inline Turn turnOf(double angle) { return {std::cos(angle), std::sin(angle)}; }
inline double angleOf(const Turn& turn) { return std::atan2(turn.y(), turn.x()); }
inline Turn sum(const Turn& a, const Turn& b) {
  return {a.x() * b.x() - a.y() * b.y(), a.y() * b.x() + a.x() * b.y()};
}
inline Turn difference(const Turn& a, const Turn& b) { return sum(a, {b.x(), -b.y()}); }

/// A vector turned about an axis of unit length.
inline Point3 turned(const Point3& vector, const Point3& axis, const Turn& turn) {
  return turn.x() * vector + turn.y() * axis.cross(vector) + ((1.0 - turn.x()) * axis.dot(vector)) * axis;
}

inline Eigen::Matrix3d matrixOf(const Point3& axis, const Turn& turn) {
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i) matrix.col(i) = turned(Point3::Unit(i), axis, turn);
  return matrix;
}

/// The two rotations by an angle t with a cos t + b sin t = d; first the one counter-clockwise of the
/// direction (a, b). If there is no solution, both are the rotation that comes nearest.
struct TwoTurns {
  std::array<Turn, 2> turns;
  double excess =
      0.0;  ///< |d| over the greatest value of the left side, less 1: positive if there is no solution
};

inline TwoTurns turnsWith(double a, double b, double d) {
  const double most = std::sqrt(a * a + b * b);
  if (most == 0.0) return {{Turn(1.0, 0.0), Turn(1.0, 0.0)}, d == 0.0 ? 0.0 : 1.0};
  const double cosine = std::clamp(d / most, -1.0, 1.0);
  const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
  const Turn middle(a / most, b / most);
  return {{sum(middle, {cosine, sine}), sum(middle, {cosine, -sine})}, std::abs(d) / most - 1.0};
}

/// The rotation about an axis that brings one direction to another, both seen along the axis. It is not
/// normalised, and zero if one of the directions is along the axis.
inline Turn turnBetween(const Point3& from, const Point3& to, const Point3& axis) {
  const double along = axis.dot(from) * axis.dot(to);
  return {from.dot(to) - along, axis.dot(from.cross(to))};
}

}  // namespace lamina
