// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/curve_places.hpp"

#include <algorithm>

namespace lamina {
namespace {

Mesh segmentsOf(const std::vector<Point3>& points, bool is_closed) {
  Mesh mesh;
  mesh.vertices = points;
  const auto count = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i + (is_closed ? 0 : 1) < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.triangles.push_back({i, next, next});
  }
  return mesh;
}

}  // namespace

CurvePlaces::CurvePlaces(const std::vector<Point3>& points, bool is_closed)
    : segments_(segmentsOf(points, is_closed)), tree_(segments_) {}

CurvePlace CurvePlaces::nearest(const Point3& point) const {
  const NearestPlace found = tree_.nearest(point);
  const Triangle& segment = segments_.triangles[found.triangle];
  const Point3& from = segments_.vertices[segment[0]];
  const Point3 along = segments_.vertices[segment[1]] - from;
  const double squared = along.squaredNorm();
  const double fraction =
      squared > 0.0 ? std::clamp((found.point - from).dot(along) / squared, 0.0, 1.0) : 0.0;
  return {found.triangle, fraction, found.point, found.distance_mm};
}

Point3 directionAt(const std::vector<Point3>& directions, const CurvePlace& place) {
  const Point3& from = directions[place.segment];
  const Point3& to = directions[(place.segment + 1) % directions.size()];
  return ((1.0 - place.fraction) * from + place.fraction * to).normalized();
}

}  // namespace lamina
