// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/delaunay.hpp"

#include <cstdint>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"
#include "geometry/polygon/point_diagram.hpp"

namespace lamina {
std::vector<Triangle> delaunayTriangles(const std::vector<Point2>& points) {
  PointDiagram diagram;
  construct(diagram, points);
  std::vector<Triangle> triangles;
  triangles.reserve(diagram.num_vertices());
  for (const auto& vertex : diagram.vertices()) {
    const std::vector<std::size_t> around = pointsAround(vertex);
    for (std::size_t i = 1; i + 1 < around.size(); ++i) {
      Triangle corner{static_cast<std::uint32_t>(around[0]), static_cast<std::uint32_t>(around[i]),
                      static_cast<std::uint32_t>(around[i + 1])};
      const double twice =
          cross(points[corner[1]] - points[corner[0]], points[corner[2]] - points[corner[0]]);
      if (twice < 0.0) std::swap(corner[1], corner[2]);
      triangles.push_back(corner);
    }
  }
  return triangles;
}

}  // namespace lamina
