// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/delaunay.hpp"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>

#include "geometry/plane_vectors.hpp"

namespace lamina {
namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;

constexpr double kFinest = 1e9;  // the diagram takes 32-bit coordinates: half of what they hold

void construct(Diagram& diagram, const std::vector<Point2>& points) {
  Box2 box;
  for (const Point2& point : points) box.include(point);
  const double scale = kFinest / std::max(0.5 * box.size().maxCoeff(), 1e-9);
  boost::polygon::voronoi_builder<std::int32_t> builder;
  for (const Point2& point : points) {
    const Point2 at = scale * (point - box.centre());
    builder.insert_point(static_cast<std::int32_t>(std::lround(at.x())),
                         static_cast<std::int32_t>(std::lround(at.y())));
  }
  builder.construct(&diagram);
}

/// The points around a vertex of the diagram, counter-clockwise.
std::vector<std::uint32_t> pointsAround(const Diagram::vertex_type& vertex) {
  std::vector<std::uint32_t> around;
  const auto* edge = vertex.incident_edge();
  do {
    around.push_back(static_cast<std::uint32_t>(edge->cell()->source_index()));
    edge = edge->rot_next();
  } while (edge != vertex.incident_edge());
  return around;
}

}  // namespace

std::vector<Triangle> delaunayTriangles(const std::vector<Point2>& points) {
  Diagram diagram;
  construct(diagram, points);
  std::vector<Triangle> triangles;
  triangles.reserve(diagram.num_vertices());
  for (const auto& vertex : diagram.vertices()) {
    const std::vector<std::uint32_t> around = pointsAround(vertex);
    for (std::size_t i = 1; i + 1 < around.size(); ++i) {
      Triangle corner{around[0], around[i], around[i + 1]};
      const double twice =
          cross(points[corner[1]] - points[corner[0]], points[corner[2]] - points[corner[0]]);
      if (twice < 0.0) std::swap(corner[1], corner[2]);
      triangles.push_back(corner);
    }
  }
  return triangles;
}

}  // namespace lamina
