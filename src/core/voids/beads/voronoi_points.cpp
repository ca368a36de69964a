// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voids/beads/voronoi_points.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "geometry/polygon/plane_vectors.hpp"
#include "geometry/polygon/point_diagram.hpp"

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

}  // namespace

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

}  // namespace lamina
