// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/mesh/wall_normals.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "geometry/mesh/area_vector.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/mesh/mesh_topology.hpp"
#include "lamina/geometry/spatial/nearest_triangle.hpp"

namespace lamina {
namespace {

constexpr double kCrease = 0.70710678118654752;  // cosine of the bend from which an edge is a corner

Mesh wallsOf(const Mesh& part, const Point3& up, double max_lean_deg) {
  const double steepest = std::sin(toRadians(max_lean_deg));
  Mesh walls;
  for (const Triangle& corner : part.triangles) {
    const Point3 normal = areaVector(part, corner);
    const double length = normal.norm();
    if (length > 0.0 && std::abs(normal.dot(up)) <= steepest * length) walls.triangles.push_back(corner);
  }
  if (walls.triangles.empty())
    throw InvalidInput("none of the part's " + std::to_string(part.triangles.size()) +
                       " faces leans at most " + numberText(max_lean_deg) +
                       " deg from the layers' normal; expected walls to follow");
  walls.vertices = part.vertices;
  return walls;
}

/// How far from its edges, opposite each corner, a point of a triangle lies: 0 at the edge, 1 at the corner.
Point3 barycentric(const Mesh& mesh, const Triangle& corner, const Point3& point) {
  const Point3 normal = areaVector(mesh, corner);
  const double squared = normal.squaredNorm();
  Point3 weights;
  for (int k = 0; k < 3; ++k) {
    const Point3& b = mesh.vertices[corner[static_cast<std::size_t>((k + 1) % 3)]];
    const Point3& c = mesh.vertices[corner[static_cast<std::size_t>((k + 2) % 3)]];
    weights[k] = std::clamp((c - b).cross(point - b).dot(normal) / squared, 0.0, 1.0);
  }
  return weights;
}

}  // namespace

struct WallNormals::Walls {
  explicit Walls(Mesh faces) : mesh(std::move(faces)), topology(pairHalfEdges(mesh)), tree(mesh) {}
  Mesh mesh;
  MeshTopology topology;
  NearestTriangle tree;
};

WallNormals::WallNormals(const Mesh& part, const Point3& up, double max_lean_deg)
    : walls_(std::make_unique<Walls>(wallsOf(part, up, max_lean_deg))) {}
WallNormals::~WallNormals() = default;
WallNormals::WallNormals(WallNormals&&) noexcept = default;
WallNormals& WallNormals::operator=(WallNormals&&) noexcept = default;

Point3 WallNormals::at(const Point3& point) const {
  const Mesh& mesh = walls_->mesh;
  const NearestPlace place = walls_->tree.nearest(point);
  const Triangle& corner = mesh.triangles[place.triangle];
  const Point3 own = areaVector(mesh, corner).normalized();
  const Point3 weights = barycentric(mesh, corner, place.point);
  Point3 sum = own;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const HalfEdge across = walls_->topology.opposite[3 * place.triangle + (k + 1) % 3];
    if (across == kNoHalfEdge) continue;
    const Point3 other = areaVector(mesh, mesh.triangles[triangleOf(across)]).normalized();
    // Whole at the edge, nothing where another edge is as near.
    const double other_edge = std::min(weights[(k + 1) % 3], weights[(k + 2) % 3]);
    const double nearness = weights[k] < other_edge ? 1.0 - weights[k] / other_edge : 0.0;
    if (other.dot(own) > kCrease) sum += nearness * other;
  }
  return sum.normalized();
}

}  // namespace lamina
