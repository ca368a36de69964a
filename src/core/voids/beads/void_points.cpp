// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/void_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/polygon/plane_vectors.hpp"
#include "geometry/polygon/point_diagram.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"

namespace lamina {
namespace {

/// The point equally far from three; none if they lie on a line.
std::optional<VoidPoint> circumcentre(const Point2& a, const Point2& b, const Point2& c) {
  const Point2 u = b - a;
  const Point2 v = c - a;
  const double twice = 2.0 * cross(u, v);
  const Point2 offset = Point2(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                               u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
                        twice;
  if (!offset.allFinite()) return std::nullopt;
  return VoidPoint{a + offset, offset.norm()};
}

/// The drops around a vertex; of more than three those that span the largest triangle with the first.
std::array<std::size_t, 3> sitesOf(const PointDiagram::vertex_type& vertex,
                                   const std::vector<Point2>& drops) {
  const std::vector<std::size_t> sites = pointsAround(vertex);
  std::array<std::size_t, 3> widest = {sites[0], sites[0], sites[0]};
  double greatest = -1.0;
  for (std::size_t i = 1; i < sites.size(); ++i)
    for (std::size_t j = i + 1; j < sites.size(); ++j) {
      const double area =
          std::abs(cross(drops[sites[i]] - drops[sites[0]], drops[sites[j]] - drops[sites[0]]));
      if (area <= greatest) continue;
      greatest = area;
      widest = {sites[0], sites[i], sites[j]};
    }
  return widest;
}

/// Vertices of the Voronoi diagram of the drops, in no particular order, some of them many times.
std::vector<VoidPoint> voronoiPoints(const std::vector<Point2>& drops) {
  PointDiagram diagram;
  construct(diagram, drops);
  std::vector<VoidPoint> points;
  points.reserve(diagram.num_vertices());
  for (const auto& vertex : diagram.vertices()) {
    const auto sites = sitesOf(vertex, drops);
    const auto centre = circumcentre(drops[sites[0]], drops[sites[1]], drops[sites[2]]);
    if (centre) points.push_back(*centre);
  }
  return points;
}

constexpr double kReach = 1.2;                  // diameters: drops within are neighbours
constexpr double kWidestGap = toRadians(95.0);  // a square lattice has gaps of 90 degrees

/// Directions to the neighbours, in order.
std::vector<double> directionsAround(const PointGrid& grid, std::uint32_t drop, double reach) {
  const Point2& centre = grid.points()[drop];
  std::vector<double> angles;
  grid.visitNear(centre, reach, [&](std::uint32_t i, double squared) {
    const Point2 to = grid.points()[i] - centre;
    if (squared > 0.0) angles.push_back(std::atan2(to.y(), to.x()));
  });
  std::sort(angles.begin(), angles.end());
  return angles;
}

/// The middle of the widest gap between directions, if it is wide enough.
std::optional<double> gapDirection(const std::vector<double>& angles) {
  double widest = kWidestGap;
  std::optional<double> direction;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double next = i + 1 < angles.size() ? angles[i + 1] : angles.front() + 2.0 * M_PI;
    if (next - angles[i] <= widest) continue;
    widest = next - angles[i];
    direction = 0.5 * (angles[i] + next);
  }
  return direction;
}

/// Distance to the nearest drop, if that is nearer than the limit; the limit otherwise.
double clearanceAt(const PointGrid& grid, const Point2& place, double limit) {
  double least = limit * limit;
  grid.visitNear(place, limit, [&](std::uint32_t, double squared) { least = std::min(least, squared); });
  return std::sqrt(least);
}

/// Places beside drops at the edge of a void, in the order of the drops: a diameter away from the drop, or as
/// near as allowed if there is no room for that.
std::vector<VoidPoint> neighbourPoints(const std::vector<Point2>& drops, const VoidSearch& search) {
  const double diameter = search.diameter_mm;
  const double least = search.least_distance_mm - 1e-6 * diameter;
  PointGrid grid(boundingBox({drops}), diameter);
  for (const Point2& drop : drops) grid.insert(drop);
  std::vector<VoidPoint> points;
  for (std::uint32_t i = 0; i < drops.size(); ++i) {
    const auto direction = gapDirection(directionsAround(grid, i, kReach * diameter));
    if (!direction) continue;
    const Point2 outwards(std::cos(*direction), std::sin(*direction));
    for (const double distance : {diameter, search.least_distance_mm}) {
      const Point2 place = drops[i] + distance * outwards;
      const double clearance = clearanceAt(grid, place, diameter);
      if (clearance < least) continue;
      points.push_back({place, clearance});
      break;
    }
  }
  return points;
}

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
