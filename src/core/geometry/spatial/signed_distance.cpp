// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/spatial/signed_distance.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "geometry/space_vectors.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"

namespace lamina {
namespace {

// Of a triangle's size: how near to a side or corner a place counts as on it.
constexpr double kOnSide = 1e-9;

Point3 unitNormal(const Mesh& mesh, const Triangle& corner) {
  const Point3 doubled = (mesh.vertices[corner[1]] - mesh.vertices[corner[0]])
                             .cross(mesh.vertices[corner[2]] - mesh.vertices[corner[0]]);
  const double norm = doubled.norm();
  return norm > 0.0 ? Point3(doubled / norm) : Point3(Point3::Zero());
}

double angleAt(const Mesh& mesh, const Triangle& corner, std::size_t k) {
  const Point3 a = mesh.vertices[corner[(k + 1) % 3]] - mesh.vertices[corner[k]];
  const Point3 b = mesh.vertices[corner[(k + 2) % 3]] - mesh.vertices[corner[k]];
  return angleBetween(a, b);
}

}  // namespace

SignedDistance::SignedDistance(const Mesh& mesh)
    : mesh_(mesh), tree_(mesh), of_vertex_(mesh.vertices.size(), Point3::Zero()) {
  of_triangle_.reserve(mesh.triangles.size());
  for (const Triangle& corner : mesh.triangles) {
    of_triangle_.push_back(unitNormal(mesh, corner));
    for (std::size_t k = 0; k < 3; ++k)
      of_vertex_[corner[k]] += angleAt(mesh, corner, k) * of_triangle_.back();
  }
  const MeshTopology topology = pairHalfEdges(mesh);
  of_side_.resize(mesh.triangles.size());
  for (std::uint32_t side = 0; side < topology.opposite.size(); ++side) {
    const HalfEdge other = topology.opposite[side];
    of_side_[side / 3][side % 3] =
        of_triangle_[side / 3] +
        (other == kNoHalfEdge ? Point3(Point3::Zero()) : of_triangle_[triangleOf(other)]);
  }
}

Point3 SignedDistance::pseudonormal(const NearestPlace& place) const {
  const Triangle& corner = mesh_.triangles[place.triangle];
  std::array<Point3, 3> to{};
  double size = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    to[k] = mesh_.vertices[corner[k]] - place.point;
    size = std::max(size, to[k].norm());
  }
  for (std::size_t k = 0; k < 3; ++k)
    if (to[k].norm() <= kOnSide * size) return of_vertex_[corner[k]];
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 along = to[(k + 1) % 3] - to[k];
    if (to[k].cross(along).norm() <= kOnSide * size * along.norm()) return of_side_[place.triangle][k];
  }
  return of_triangle_[place.triangle];
}

SignedPlace SignedDistance::at(const Point3& point) const {
  const NearestPlace place = tree_.nearest(point);
  const bool is_outside = (point - place.point).dot(pseudonormal(place)) > 0.0;
  return {is_outside ? -place.distance_mm : place.distance_mm, place};
}

}  // namespace lamina
