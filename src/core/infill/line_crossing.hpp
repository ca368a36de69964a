// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Positive if b is to the left of a.
inline double crossProduct(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Whether the line from a to b crosses that from c to d.
inline bool areCrossing(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return (crossProduct(b - a, c - a) > 0.0) != (crossProduct(b - a, d - a) > 0.0) &&
         (crossProduct(d - c, a - c) > 0.0) != (crossProduct(d - c, b - c) > 0.0);
}

}  // namespace lamina
