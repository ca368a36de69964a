// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/point_diagram.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lamina {
namespace {

constexpr double kFinest = 1e9;  // the diagram takes 32-bit coordinates: half of what they hold

}  // namespace

void construct(PointDiagram& diagram, const std::vector<Point2>& points) {
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

std::vector<std::size_t> pointsAround(const PointDiagram::vertex_type& vertex) {
  std::vector<std::size_t> around;
  const auto* edge = vertex.incident_edge();
  do {
    around.push_back(edge->cell()->source_index());
    edge = edge->rot_next();
  } while (edge != vertex.incident_edge());
  return around;
}

}  // namespace lamina
