// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Whether two boxes overlap or touch.
template <class Point>
bool areOverlapping(const Box<Point>& a, const Box<Point>& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

/// Whether a point lies in a box or on its border.
inline bool isInBox(const Box3& box, const Point3& point) {
  return (point.array() >= box.low.array()).all() && (point.array() <= box.high.array()).all();
}

}  // namespace lamina
