// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "lamina/base/random.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina::test {

/// Counter-clockwise rectangle [mm].
inline Polygon rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// The same outline run the other way: a hole.
inline Polygon reversed(const Polygon& polygon) { return {polygon.rbegin(), polygon.rend()}; }

/// Counter-clockwise regular polygon [mm].
inline Polygon circle(const Point2& centre, double radius, int sides) {
  Polygon polygon;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * M_PI * i / sides;
    polygon.push_back(centre + radius * Point2(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}

/// Counter-clockwise outline round the centre whose radius varies at random between the bounds [mm]; simple.
inline Polygon star(Random& random, const Point2& centre, double least_radius, double greatest_radius,
                    int points) {
  Polygon polygon;
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * M_PI * i / points;
    const double radius = random.uniform(least_radius, greatest_radius);
    polygon.push_back(centre + radius * Point2(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}

/// Distance from a point to the nearest point of the outlines [mm].
inline double distanceToOutline(const std::vector<Polygon>& polygons, const Point2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Polygon& polygon : polygons) {
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
      const Point2 along = polygon[i] - polygon[j];
      const double squared = along.squaredNorm();
      const double t = squared == 0.0 ? 0.0 : std::clamp((point - polygon[j]).dot(along) / squared, 0.0, 1.0);
      nearest = std::min(nearest, (polygon[j] + t * along - point).norm());
    }
  }
  return nearest;
}

}  // namespace lamina::test
