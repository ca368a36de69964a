// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/curved/vertex_reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// Of a ball's radius: what may lie inside it, and as much again where only a neighbour's ball was looked at.
constexpr double kReachSlack = 0.01;
constexpr double kLeastExactness = 0.5;
constexpr int kMostBalls = 40;
constexpr std::size_t kMostKept = 8;
// How far outside the part a vertex may lie that slides along its surface [mm].
constexpr double kReachTouching = 1e-3;
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

/// Shrinks the balls of one vertex after the other. What was found for one says much about its neighbours:
/// where their balls touch too, and that they are as empty if their centres are near.
class CollapseSearch {
 public:
  explicit CollapseSearch(const NearestTriangle& source) : source_(source) {}

  double collapseOf(const Point3& vertex, const VertexMotion& motion, double farthest) {
    const double ratio = (1.0 - kReachSlack) * std::max(kLeastExactness, motion.exactness);
    double radius = farthest;
    for (const Ball& ball : balls_)
      if (ball.touched) radius = smaller(radius, vertex - *ball.touched, motion, ratio);
    const Point3 centre = vertex + radius * motion.per_mm;
    const bool is_empty = std::any_of(balls_.begin(), balls_.end(), [&](const Ball& ball) {
      return ball.empty_mm - (centre - ball.centre).norm() >= (ratio - kReachSlack) * radius;
    });
    return is_empty ? radius : shrunk(vertex, motion, ratio, radius);
  }

 private:
  struct Ball {
    Point3 centre;
    double empty_mm;                // radius within which nothing of the source is
    std::optional<Point3> touched;  // what stopped it from being greater
  };

  static double smaller(double radius, const Point3& to_vertex, const VertexMotion& motion, double ratio) {
    if ((to_vertex + radius * motion.per_mm).norm() >= ratio * radius) return radius;
    return std::min(radius, touchingRadius(to_vertex, motion, ratio));
  }

  double shrunk(const Point3& vertex, const VertexMotion& motion, double ratio, double radius) {
    Ball ball{vertex, 0.0, std::nullopt};
    for (int i = 0; i < kMostBalls && radius > 0.0; ++i) {
      ball.centre = vertex + radius * motion.per_mm;
      const auto nearest = source_.nearest(ball.centre, radius);
      ball.empty_mm = nearest ? nearest->distance_mm : radius;
      if (ball.empty_mm >= ratio * radius) break;
      ball.touched = nearest->point;
      const double next = touchingRadius(vertex - nearest->point, motion, ratio);
      if (!(next < radius * (1.0 - 1e-6))) break;
      radius = next;
    }
    if (balls_.size() == kMostKept) balls_.erase(balls_.begin());
    balls_.push_back(ball);
    return radius;
  }

  const NearestTriangle& source_;
  std::vector<Ball> balls_;
};

double bisectedExit(const Point3& vertex, const VertexMotion& motion, double inside, double outside,
                    const ShellLimits& limits) {
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (inside + outside);
    (limits.allowed(vertex + middle * motion.per_mm) < 0.0 ? outside : inside) = middle;
  }
  return 0.5 * (inside + outside);
}

/// A path that starts on the surface leaves the part through the rest of it: as far as that is away, nothing
/// need be looked at.
double exitOf(const Point3& vertex, const VertexMotion& motion, double farthest, const ShellLimits& limits) {
  if (limits.part == nullptr || limits.rest == nullptr) return kNever;
  const double speed = std::max(1e-9, motion.per_mm.norm());
  double offset = 0.0;
  while (offset <= farthest + limits.step_mm) {
    const double ahead = (farthest + limits.step_mm - offset) * speed + kReachTouching;
    const auto nearest = limits.rest->nearest(vertex + offset * motion.per_mm, ahead);
    if (!nearest) return kNever;
    const double free = nearest->distance_mm / speed;
    if (free < limits.step_mm) {
      const double next = offset + limits.step_mm;
      if (limits.allowed(vertex + next * motion.per_mm) < -kReachTouching)
        return bisectedExit(vertex, motion, offset, next, limits);
    }
    offset += std::max(free, limits.step_mm);
  }
  return kNever;
}

}  // namespace

VertexReach vertexReach(const MovableSurface& moving, const ShellLimits& limits, Progress& progress) {
  const std::size_t count = moving.surface.vertices.size();
  VertexReach reach{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
  const auto measure = [&](std::size_t i, CollapseSearch& search) {
    const Point3& vertex = moving.surface.vertices[i];
    reach.bound_mm[i] = boundOf(vertex, moving.motions[i], limits.bound);
    // Beyond the bound it matters no more what happens to it.
    const double farthest = std::min(limits.farthest_mm, reach.bound_mm[i] + 2.0 * limits.step_mm);
    const double collapse = search.collapseOf(vertex, moving.motions[i], farthest);
    reach.collapse_mm[i] = collapse < farthest ? collapse : limits.farthest_mm;
    reach.exit_mm[i] = exitOf(vertex, moving.motions[i], std::min(farthest, collapse), limits);
  };
  const auto measureBatch = [&](std::size_t batch) {
    CollapseSearch search(moving.source);
    for (std::size_t i = batch * kBatch; i < std::min(count, (batch + 1) * kBatch); ++i) measure(i, search);
  };
  parallelFor((count + kBatch - 1) / kBatch, measureBatch, progress, "measure shells");
  return reach;
}

}  // namespace lamina
