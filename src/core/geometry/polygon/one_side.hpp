// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {

/// Twice the area of a triangle that counts as flat [mm²]: above the rounding of coordinates of metres.
constexpr double kFlatTriangle = 1e-8;

/// Whether the points c and d lie clearly on the same side of the line through a and b.
inline bool leavesOnOneSide(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const double first = side(a, b, c);
  const double second = side(a, b, d);
  return (first > kFlatTriangle && second > kFlatTriangle) ||
         (first < -kFlatTriangle && second < -kFlatTriangle);
}

}  // namespace lamina
