// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace lamina {

/// A point or direction in the plane of a layer [mm].
using Point2 = Eigen::Vector2d;
/// A point or direction in space [mm].
using Point3 = Eigen::Vector3d;

/// Axis-aligned box [mm]; empty (isEmpty) until something is put in.
template <class Point>
struct Box {
  Point low = Point::Constant(std::numeric_limits<double>::infinity());
  Point high = Point::Constant(-std::numeric_limits<double>::infinity());

  bool isEmpty() const { return low.x() > high.x(); }
  Point size() const { return isEmpty() ? Point(Point::Zero()) : Point(high - low); }
  Point centre() const { return 0.5 * (low + high); }
  void include(const Point& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
};

using Box2 = Box<Point2>;
using Box3 = Box<Point3>;

}  // namespace lamina
