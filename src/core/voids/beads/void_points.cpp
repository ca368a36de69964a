// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/void_points.hpp"

#include <algorithm>

#include "lamina/geometry/spatial/point_grid.hpp"
#include "voids/beads/neighbour_points.hpp"
#include "voids/beads/voronoi_points.hpp"

namespace lamina {
namespace {

constexpr double kSamePlace = 1e-6;  // of a diameter

/// Points at one place become one.
std::vector<VoidPoint> merged(std::vector<VoidPoint> points, double tolerance) {
  std::sort(points.begin(), points.end(), [](const VoidPoint& a, const VoidPoint& b) {
    return a.position.x() != b.position.x() ? a.position.x() < b.position.x()
                                            : a.position.y() < b.position.y();
  });
  Box2 box;
  for (const VoidPoint& point : points) box.include(point.position);
  PointGrid kept(box, 1e5 * tolerance);
  std::vector<VoidPoint> single;
  for (const VoidPoint& point : points) {
    if (kept.hasNearer(point.position, tolerance)) continue;
    kept.insert(point.position);
    single.push_back(point);
  }
  return single;
}

}  // namespace

std::vector<VoidPoint> findVoidPoints(VoidDetector detector, const std::vector<Point2>& drops,
                                      const VoidSearch& search) {
  if (drops.size() < 3) return {};
  std::vector<VoidPoint> points =
      detector == VoidDetector::Voronoi ? voronoiPoints(drops) : neighbourPoints(drops, search);
  const double tolerance = kSamePlace * search.diameter_mm;
  const Box2 box = boundingBox({drops});
  const auto is_out = [&](const VoidPoint& point) {
    // Nearly straight rows of drops have vertices far away.
    return point.clearance_mm < search.least_distance_mm - tolerance ||
           (point.position.array() < box.low.array() - search.diameter_mm).any() ||
           (point.position.array() > box.high.array() + search.diameter_mm).any();
  };
  points.erase(std::remove_if(points.begin(), points.end(), is_out), points.end());
  return merged(std::move(points), tolerance);
}

std::vector<VoidPoint> inside(const std::vector<Polygon>& borders, const std::vector<VoidPoint>& points) {
  std::vector<VoidPoint> found;
  std::copy_if(points.begin(), points.end(), std::back_inserter(found),
               [&](const VoidPoint& point) { return contains(borders, point.position); });
  return found;
}

}  // namespace lamina
