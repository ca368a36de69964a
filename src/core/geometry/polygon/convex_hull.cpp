// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/polygon/convex_hull.hpp"

#include <algorithm>
#include <cstddef>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

/// Adds a point to a chain that only turns left, of which the first `kept` points stay.
void extend(Polygon& chain, std::size_t kept, const Point2& point) {
  while (chain.size() >= kept + 1 && chain.size() >= 2 &&
         !(side(chain[chain.size() - 2], chain.back(), point) > 0.0))
    chain.pop_back();
  chain.push_back(point);
}

}  // namespace

Polygon convexHull(std::vector<Point2> points) {
  std::sort(points.begin(), points.end(),
            [](const Point2& a, const Point2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  Polygon hull;
  for (const Point2& point : points) extend(hull, 1, point);
  const std::size_t lower = hull.size();
  for (std::size_t i = points.size(); i-- > 0;) extend(hull, lower, points[i]);
  if (!hull.empty()) hull.pop_back();
  if (hull.size() < 3) hull.clear();
  return hull;
}

}  // namespace lamina
