// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voids/beads/neighbour_points.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lamina/geometry/spatial/point_grid.hpp"

namespace lamina {
namespace {

constexpr double kReach = 1.2;                      // diameters: drops within are neighbours
constexpr double kWidestGap = 95.0 * M_PI / 180.0;  // a square lattice has gaps of 90 degrees

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

}  // namespace

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

}  // namespace lamina
