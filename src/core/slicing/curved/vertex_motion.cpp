// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/curved/vertex_motion.hpp"
#include "geometry/space_vectors.hpp"

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

// Per millimetre: by how much the planes at a vertex advance at least, in the mean.
constexpr double kLeastAdvance = 0.5;
// Of a vertex held to walls: walls that lean more would have it run along them away from the surface.
constexpr double kLongestHeldPath = 2.0;
// Greatest share of what is asked that a held vertex may miss.
constexpr double kMostMiss = 0.05;
// Cosine of the angle within which a wall goes on from the surface.
constexpr double kSmooth = 0.75;

/// The normal equations of N s = 1 at a vertex, with weights that add up to 1, and of H s = 0.
struct Equations {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Point3 right = Point3::Zero();
  double weight = 0.0;
  Eigen::Matrix3d walls = Eigen::Matrix3d::Zero();
};

struct Solution {
  Point3 path = Point3::Zero();
  int rank = 0;
};

/// The shortest solution within the directions that `within` projects to.
Solution shortest(const Equations& equations, const Eigen::Matrix3d& within) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.compute(within * equations.matrix * within);
  Solution solution;
  for (int i = 0; i < 3; ++i) {
    const double value = solver.eigenvalues()[i];
    if (!(value > kLeastEigenvalue)) continue;
    const Point3 direction = solver.eigenvectors().col(i);
    solution.path += direction.dot(within * equations.right) / value * direction;
    ++solution.rank;
  }
  return solution;
}

/// The directions in which planes of the given normals (as the sum of n n^T) can be slid along.
Eigen::Matrix3d alongAll(const Eigen::Matrix3d& normals) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.compute(normals);
  Eigen::Matrix3d projection = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Point3 direction = solver.eigenvectors().col(i);
    if (solver.eigenvalues()[i] <= kLeastEigenvalue * solver.eigenvalues()[2])
      projection += direction * direction.transpose();
  }
  return projection;
}

/// The path held to planes, if the surface's own planes still move as they should.
std::optional<Point3> heldPath(const Equations& equations, const Eigen::Matrix3d& normals, double longest) {
  if (normals.isZero(0.0)) return std::nullopt;
  const Point3 path = shortest(equations, alongAll(normals)).path;
  if (path.norm() > longest) return std::nullopt;
  // |N s - 1|^2 by weights, of which those of `right` are part.
  const double missed = path.dot(equations.matrix * path) - 2.0 * path.dot(equations.right) + 1.0;
  if (missed > kMostMiss * kMostMiss) return std::nullopt;
  return path;
}

VertexMotion motionOf(const Equations& equations, const ShellBound* bound) {
  VertexMotion motion;
  const double norm = equations.right.norm();
  if (!(norm > 0.0)) return motion;
  motion.normal = equations.right / norm;
  const Solution free = shortest(equations, Eigen::Matrix3d::Identity());
  motion.planes = std::max(1, free.rank);
  // At a needle the directions cut off are those that matter: it moves along its axis.
  const bool is_needle = free.path.dot(equations.right) < kLeastAdvance;
  motion.per_mm = is_needle ? Point3(std::min(kLongestPath, 1.0 / norm) * motion.normal) : free.path;
  const double length = motion.per_mm.norm();
  if (length > kLongestPath) motion.per_mm *= kLongestPath / length;
  const Eigen::Matrix3d level =
      bound == nullptr ? Eigen::Matrix3d(Eigen::Matrix3d::Zero()) : bound->normal * bound->normal.transpose();
  auto path = heldPath(equations, level + equations.walls, kLongestHeldPath);
  if (!path) path = heldPath(equations, level, kLongestPath);
  if (!path) path = heldPath(equations, equations.walls, kLongestHeldPath);
  if (path) motion.per_mm = *path;
  return motion;
}

double angleAt(const Point3& corner, const Point3& next, const Point3& previous) {
  return angleBetween(next - corner, previous - corner);
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

std::vector<Equations> equationsOf(const Mesh& mesh) {
  std::vector<Equations> equations(mesh.vertices.size());
  for (const Triangle& corner : mesh.triangles) {
    const Point3 normal = unitNormal(mesh, corner);
    if (normal.isZero(0.0)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const double weight = angleAt(mesh.vertices[corner[k]], mesh.vertices[corner[(k + 1) % 3]],
                                    mesh.vertices[corner[(k + 2) % 3]]);
      equations[corner[k]].matrix += weight * normal * normal.transpose();
      equations[corner[k]].right += weight * normal;
      equations[corner[k]].weight += weight;
    }
  }
  for (Equations& equation : equations) {
    if (!(equation.weight > 0.0)) continue;
    equation.matrix /= equation.weight;
    equation.right /= equation.weight;
  }
  return equations;
}

std::vector<VertexMotion> motionsOf(const Mesh& mesh, const std::vector<Equations>& equations,
                                    const std::optional<ShellBound>& bound) {
  std::vector<VertexMotion> motions;
  motions.reserve(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const bool is_on_bound =
        bound && std::abs(bound->normal.dot(mesh.vertices[i]) - bound->offset_mm) <= kOnBound;
    motions.push_back(motionOf(equations[i], is_on_bound ? &*bound : nullptr));
  }
  return motions;
}

std::vector<VertexMotion> motionsOf(const ShellSource& source, const std::optional<ShellBound>& bound) {
  std::vector<Equations> equations = equationsOf(source.surface);
  for (const RimWall& wall : source.walls) {
    Equations& at = equations[wall.vertex];
    if (std::abs(wall.normal.dot(at.right)) < kSmooth * at.right.norm())
      at.walls += wall.normal * wall.normal.transpose();
  }
  return motionsOf(source.surface, equations, bound);
}

}  // namespace

std::vector<VertexMotion> vertexMotions(const ShellSource& source, const Subdivision& subdivision,
                                        const std::optional<ShellBound>& bound) {
  const std::vector<VertexMotion> of_source = motionsOf(source, bound);
  std::vector<VertexMotion> motions =
      motionsOf(subdivision.mesh, equationsOf(subdivision.mesh), std::nullopt);
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
