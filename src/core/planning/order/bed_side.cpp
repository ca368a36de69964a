// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/bed_side.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace lamina {
namespace {

constexpr double kEquallyNear = 1e-6;  // mm: rounding of rotations

}  // namespace

std::optional<Point2> bedSide(const Layer& layer, const BedPlane& bed) {
  const auto height = [&](const Point2& point) {
    return bed.heightOf({point.x(), point.y(), layer.bounds.top_mm});
  };
  double lowest = std::numeric_limits<double>::infinity();
  for (const Polygon& contour : layer.section.contours)
    for (const Point2& point : contour) lowest = std::min(lowest, height(point));
  std::optional<Point2> side;
  for (const Polygon& contour : layer.section.contours)
    for (const Point2& point : contour)
      if (height(point) <= lowest + kEquallyNear &&
          (!side || std::make_pair(point.x(), point.y()) < std::make_pair(side->x(), side->y())))
        side = point;
  return side;
}

}  // namespace lamina
