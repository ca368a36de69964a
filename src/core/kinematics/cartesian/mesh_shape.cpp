// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "lamina/kinematics/cartesian/machine_bodies.hpp"

namespace lamina {
namespace {

constexpr int kDirections = 256;       // in which the outermost vertex is a point of the hull
constexpr int kApproaches = 40;        // of a vertex by points of the hull
constexpr double kCloseEnough = 0.01;  // mm: far below what a table of poses distinguishes

/// Evenly spread over the sphere, along a spiral.
Point3 directionAt(int i) {
  const double z = 1.0 - (2.0 * i + 1.0) / kDirections;
  const double around = i * M_PI * (3.0 - std::sqrt(5.0));
  const double radius = std::sqrt(1.0 - z * z);
  return {radius * std::cos(around), radius * std::sin(around), z};
}

std::vector<Point3> outermost(const std::vector<Point3>& points) {
  std::set<std::size_t> chosen;
  for (int i = 0; i < kDirections; ++i) {
    const Point3 direction = directionAt(i);
    const auto furthest = std::max_element(
        points.begin(), points.end(),
        [&](const Point3& a, const Point3& b) { return direction.dot(a) < direction.dot(b); });
    chosen.insert(static_cast<std::size_t>(furthest - points.begin()));
  }
  std::vector<Point3> hull;
  hull.reserve(chosen.size());
  for (const std::size_t index : chosen) hull.push_back(points[index]);
  return hull;
}

/// Distance of a point to one within the hull, found by steps towards its corners: never less than that to
/// the hull.
double distanceTo(const std::vector<Point3>& hull, const Point3& point) {
  Point3 within = hull.front();
  for (int step = 0; step < kApproaches; ++step) {
    const Point3 gap = point - within;
    if (gap.norm() < kCloseEnough) break;
    const Point3& corner = *std::max_element(
        hull.begin(), hull.end(), [&](const Point3& a, const Point3& b) { return gap.dot(a) < gap.dot(b); });
    const Point3 way = corner - within;
    const double along = way.dot(gap);
    if (!(along > 0.0)) break;
    within += std::min(1.0, along / way.squaredNorm()) * way;
  }
  return (point - within).norm();
}

}  // namespace

MeshShape meshShape(Mesh mesh) {
  MeshShape shape;
  const std::vector<Point3> hull = outermost(mesh.vertices);
  for (const Point3& vertex : mesh.vertices)
    shape.margin_mm = std::max(shape.margin_mm, distanceTo(hull, vertex));
  shape.hull = std::make_shared<const std::vector<Point3>>(hull);
  shape.mesh = std::make_shared<const Mesh>(std::move(mesh));
  return shape;
}

}  // namespace lamina
