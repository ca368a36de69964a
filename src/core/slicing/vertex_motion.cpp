// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/vertex_motion.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

// Of the greatest eigenvalue of the normal equations, the square of what N's singular values are cut at.
constexpr double kLeastEigenvalue = 0.01;
constexpr double kLongestPath = 4.0;
// How near to the bound's plane a vertex counts as on it [mm].
constexpr double kOnBound = 1e-6;

/// The normal equations of N s = 1 at a vertex.
struct Equations {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Point3 right = Point3::Zero();
};

struct Solution {
  Point3 path = Point3::Zero();
  int rank = 0;
};

Solution shortest(const Equations& equations, double scale) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(equations.matrix);
  Solution solution;
  for (int i = 0; i < 3; ++i) {
    const double value = solver.eigenvalues()[i];
    if (!(value > kLeastEigenvalue * scale)) continue;
    const Point3 direction = solver.eigenvectors().col(i);
    solution.path += direction.dot(equations.right) / value * direction;
    ++solution.rank;
  }
  return solution;
}

VertexMotion motionOf(const Equations& equations, const ShellBound* bound) {
  VertexMotion motion;
  const double norm = equations.right.norm();
  if (!(norm > 0.0)) return motion;
  motion.normal = equations.right / norm;
  const double scale = equations.matrix.trace();
  const Solution free = shortest(equations, scale);
  motion.planes = std::max(1, free.rank);
  motion.per_mm = free.rank > 0 ? free.path : motion.normal;
  if (bound != nullptr) {
    const Eigen::Matrix3d level = Eigen::Matrix3d::Identity() - bound->normal * bound->normal.transpose();
    const Solution held = shortest({level * equations.matrix * level, level * equations.right}, scale);
    if (held.rank > 0 && held.path.norm() <= kLongestPath) motion.per_mm = held.path;
  }
  const double length = motion.per_mm.norm();
  if (length > kLongestPath) motion.per_mm *= kLongestPath / length;
  return motion;
}

double angleAt(const Point3& corner, const Point3& next, const Point3& previous) {
  const Point3 a = next - corner;
  const Point3 b = previous - corner;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Point3 unitNormal(const Mesh& mesh, const Triangle& corner) {
  const Point3& a = mesh.vertices[corner[0]];
  return (mesh.vertices[corner[1]] - a).cross(mesh.vertices[corner[2]] - a).stableNormalized();
}

/// How far the planes of the triangles at each vertex advance at least.
void setExactness(const Mesh& mesh, std::vector<VertexMotion>& motions) {
  for (VertexMotion& motion : motions) motion.exactness = 1.0;
  for (const Triangle& triangle : mesh.triangles) {
    const Point3 normal = unitNormal(mesh, triangle);
    if (normal.isZero(0.0)) continue;
    for (const std::uint32_t corner : triangle)
      motions[corner].exactness = std::min(motions[corner].exactness, normal.dot(motions[corner].per_mm));
  }
}

}  // namespace

std::vector<VertexMotion> vertexMotions(const Mesh& mesh, const std::optional<ShellBound>& bound) {
  std::vector<Equations> equations(mesh.vertices.size());
  for (const Triangle& corner : mesh.triangles) {
    const Point3 normal = unitNormal(mesh, corner);
    for (std::size_t k = 0; k < 3; ++k) {
      const double weight = angleAt(mesh.vertices[corner[k]], mesh.vertices[corner[(k + 1) % 3]],
                                    mesh.vertices[corner[(k + 2) % 3]]);
      equations[corner[k]].matrix += weight * normal * normal.transpose();
      equations[corner[k]].right += weight * normal;
    }
  }
  std::vector<VertexMotion> motions;
  motions.reserve(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const bool is_on_bound =
        bound && std::abs(bound->normal.dot(mesh.vertices[i]) - bound->offset_mm) <= kOnBound;
    motions.push_back(motionOf(equations[i], is_on_bound ? &*bound : nullptr));
  }
  setExactness(mesh, motions);
  return motions;
}

std::vector<VertexMotion> vertexMotions(const Mesh& source, const Subdivision& subdivision,
                                        const std::optional<ShellBound>& bound) {
  const std::vector<VertexMotion> of_source = vertexMotions(source, bound);
  std::vector<VertexMotion> motions = vertexMotions(subdivision.mesh, bound);
  std::copy(of_source.begin(), of_source.end(), motions.begin());
  std::size_t vertex = of_source.size();
  for (const auto& [first, second] : subdivision.ends) {
    motions[vertex].per_mm = 0.5 * (motions[first].per_mm + motions[second].per_mm);
    // On a facet between edges the normal is the facet's own.
    if (motions[first].planes == 1 && motions[second].planes == 1)
      motions[vertex].normal = (motions[first].normal + motions[second].normal).stableNormalized();
    ++vertex;
  }
  setExactness(subdivision.mesh, motions);
  return motions;
}

}  // namespace lamina
