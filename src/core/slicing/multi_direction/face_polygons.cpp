// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/multi_direction/face_polygons.hpp"

#include <algorithm>

namespace lamina {
namespace {

/// Where the plane crosses the way from one point to another.
Point3 crossingOf(const CuttingPlane& plane, const Point3& from, const Point3& to) {
  const double start = plane.heightOf(from);
  const double share = start / (start - plane.heightOf(to));
  return from + share * (to - from);
}

/// What of a convex polygon is below a plane.
std::vector<Point3> partBelow(const Point3* first, const Point3* last, const CuttingPlane& plane) {
  std::vector<Point3> part;
  for (const Point3* at = first; at != last; ++at) {
    const Point3& next = at + 1 == last ? *first : at[1];
    if (plane.isBelow(*at)) part.push_back(*at);
    if (plane.isBelow(*at) != plane.isBelow(next)) part.push_back(crossingOf(plane, *at, next));
  }
  return part;
}

double areaOf(const std::vector<Point3>& polygon, const Point3& normal) {
  Point3 sum = Point3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  return std::max(0.0, 0.5 * sum.dot(normal));
}

}  // namespace

FacePolygons::FacePolygons(const Mesh& mesh) {
  for (const Triangle& corner : mesh.triangles) {
    const std::vector<Point3> polygon = {mesh.vertices[corner[0]], mesh.vertices[corner[1]],
                                         mesh.vertices[corner[2]]};
    const Point3 across = (polygon[1] - polygon[0]).cross(polygon[2] - polygon[0]);
    if (across.norm() > 0.0) add(polygon, across.normalized());
  }
}

void FacePolygons::add(const std::vector<Point3>& polygon, const Point3& normal) {
  const double area = polygon.size() < 3 ? 0.0 : areaOf(polygon, normal);
  if (!(area > 0.0)) return;
  corners_.insert(corners_.end(), polygon.begin(), polygon.end());
  first_.push_back(static_cast<std::uint32_t>(corners_.size()));
  normals_.push_back(normal);
  areas_.push_back(area);
}

FacePolygons FacePolygons::below(const CuttingPlane& plane) const {
  FacePolygons left;
  for (std::uint32_t face = 0; face < count(); ++face)
    left.add(partBelow(begin(face), end(face), plane), normal(face));
  return left;
}

double FacePolygons::areaAbove(std::uint32_t face, const CuttingPlane& plane) const {
  const auto isBelow = [&](const Point3& corner) { return plane.isBelow(corner); };
  if (std::none_of(begin(face), end(face), isBelow)) return area(face);
  return std::max(0.0, area(face) - areaOf(partBelow(begin(face), end(face), plane), normal(face)));
}

Mesh FacePolygons::meshOf(const std::vector<std::uint32_t>& faces) const {
  Mesh mesh;
  for (const std::uint32_t face : faces) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), begin(face), end(face));
    for (std::uint32_t i = first + 1; i + 1 < mesh.vertices.size(); ++i)
      mesh.triangles.push_back({first, i, i + 1});
  }
  return mesh;
}

}  // namespace lamina
