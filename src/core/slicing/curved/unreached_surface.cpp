// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/curved/unreached_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/mesh/area_vector.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/geometry/spatial/nearest_triangle.hpp"

namespace lamina {
namespace {

// Of an edge's length: how near to it a place counts as on it.
constexpr double kOnEdge = 1e-6;

bool isOnBorder(const Mesh& source, const MeshTopology& topology, const NearestPlace& place) {
  for (HalfEdge side = 3 * place.triangle; side < 3 * place.triangle + 3; ++side) {
    if (topology.opposite[side] != kNoHalfEdge) continue;
    const Point3& from = source.vertices[originOf(source, side)];
    const Point3 along = source.vertices[originOf(source, nextInTriangle(side))] - from;
    if ((place.point - from).cross(along).norm() <= kOnEdge * along.squaredNorm()) return true;
  }
  return false;
}

}  // namespace

TriangleNumbers unreached(const Mesh& mesh, const TriangleNumbers& candidates, const Mesh& source,
                          double within_mm) {
  const MeshTopology topology = pairHalfEdges(source);
  const NearestTriangle nearest(source);
  TriangleNumbers result;
  for (const std::uint32_t number : candidates) {
    const Triangle& corner = mesh.triangles[number];
    const Point3 middle =
        (mesh.vertices[corner[0]] + mesh.vertices[corner[1]] + mesh.vertices[corner[2]]) / 3.0;
    const NearestPlace place = nearest.nearest(middle);
    if (!isOnBorder(source, topology, place)) continue;
    const Point3 away = middle - place.point;
    const Point3 normal = triangleNormal(source, place.triangle);
    if ((away - away.dot(normal) * normal).norm() > within_mm) result.push_back(number);
  }
  return result;
}

std::vector<Point3> unreached(const std::vector<Point3>& points, const Mesh& source, double within_mm,
                              double steepest_deg) {
  const MeshTopology topology = pairHalfEdges(source);
  const NearestTriangle nearest(source);
  const double per_mm = std::tan(toRadians(steepest_deg));
  std::vector<Point3> result;
  for (const Point3& point : points) {
    const NearestPlace place = nearest.nearest(point);
    if (!isOnBorder(source, topology, place)) continue;
    const Point3 normal = triangleNormal(source, place.triangle);
    const Point3 away = point - place.point;
    const double ahead = away.dot(normal);
    if ((away - ahead * normal).norm() > within_mm + per_mm * std::max(0.0, ahead)) result.push_back(point);
  }
  return result;
}

}  // namespace lamina
