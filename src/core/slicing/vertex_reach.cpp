// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/vertex_reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// Of a ball's radius: what may lie inside it.
constexpr double kSlack = 0.01;
constexpr double kLeastExactness = 0.5;
constexpr int kMostBalls = 40;
// How far outside the part a vertex may lie that slides along its surface [mm].
constexpr double kTouching = 1e-3;
constexpr int kBisections = 12;
constexpr std::size_t kBatch = 256;

double boundOf(const Point3& place, const VertexMotion& motion, const std::optional<ShellBound>& bound) {
  if (!bound) return kNever;
  const double speed = bound->normal.dot(motion.per_mm);
  if (speed <= 1e-9) return kNever;
  return std::max(0.0, (bound->offset_mm - bound->normal.dot(place)) / speed);
}

/// The radius at which a ball that grows along the motion touches a place.
double touchingRadius(const Point3& to_vertex, const VertexMotion& motion, double ratio) {
  const double a = motion.per_mm.squaredNorm() - ratio * ratio;
  const double b = to_vertex.dot(motion.per_mm);
  const double c = to_vertex.squaredNorm();
  const double root = std::sqrt(std::max(0.0, b * b - a * c));
  return c / (root - b);
}

double collapseOf(const Point3& vertex, const VertexMotion& motion, double farthest,
                  const NearestTriangle& surface) {
  const double ratio = (1.0 - kSlack) * std::max(kLeastExactness, motion.exactness);
  double radius = farthest;
  for (int i = 0; i < kMostBalls && radius > 0.0; ++i) {
    const auto inside = surface.nearest(vertex + radius * motion.per_mm, ratio * radius);
    if (!inside) break;
    const double smaller = touchingRadius(vertex - inside->point, motion, ratio);
    if (!(smaller < radius * (1.0 - 1e-6))) break;
    radius = smaller;
  }
  return radius;
}

double bisectedExit(const Point3& vertex, const VertexMotion& motion, double inside, double outside,
                    const ShellLimits& limits) {
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (inside + outside);
    (limits.allowed(vertex + middle * motion.per_mm) < 0.0 ? outside : inside) = middle;
  }
  return 0.5 * (inside + outside);
}

/// Looks at every step that the distance to the part's surface does not let pass.
double exitOf(const Point3& vertex, const VertexMotion& motion, double farthest, const ShellLimits& limits) {
  if (limits.part == nullptr) return kNever;
  const double speed = std::max(1e-9, motion.per_mm.norm());
  double safe = 0.0;
  for (double i = 0.0;;) {
    const double offset = (i + 0.5) * limits.step_mm;
    if (offset > farthest + limits.step_mm) return kNever;
    const double inside = limits.allowed(vertex + offset * motion.per_mm);
    if (inside < -kTouching) return bisectedExit(vertex, motion, safe, offset, limits);
    safe = offset + std::max(0.0, inside) / speed;
    i = std::max(i + 1.0, std::floor(safe / limits.step_mm + 0.5));
  }
}

}  // namespace

VertexReach vertexReach(const MovableSurface& moving, const ShellLimits& limits, Progress& progress) {
  const std::size_t count = moving.surface.vertices.size();
  VertexReach reach{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
  const auto measure = [&](std::size_t i) {
    const Point3& vertex = moving.surface.vertices[i];
    reach.bound_mm[i] = boundOf(vertex, moving.motions[i], limits.bound);
    // Beyond the bound it matters no more what happens to it.
    const double farthest = std::min(limits.farthest_mm, reach.bound_mm[i] + 2.0 * limits.step_mm);
    const double collapse = collapseOf(vertex, moving.motions[i], farthest, moving.source);
    reach.collapse_mm[i] = collapse < farthest ? collapse : limits.farthest_mm;
    reach.exit_mm[i] = exitOf(vertex, moving.motions[i], std::min(farthest, collapse), limits);
  };
  const auto measureBatch = [&](std::size_t batch) {
    for (std::size_t i = batch * kBatch; i < std::min(count, (batch + 1) * kBatch); ++i) measure(i);
  };
  parallelFor((count + kBatch - 1) / kBatch, measureBatch, progress, "measure shells");
  return reach;
}

}  // namespace lamina
