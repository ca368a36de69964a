// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/parameterization/flattening.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lamina/parameterization/distortion.hpp"
#include "parameterization/arap.hpp"
#include "parameterization/landmark_mds.hpp"
#include "parameterization/smacof.hpp"
#include "parameterization/unfolding.hpp"

namespace lamina {
namespace {

// Surfaces that keep their lengths to this share when they are unrolled need no better plan.
constexpr double kUnrollsFlat = 0.005;
// A surface that faces its mean direction so much (cosine of the angle) is projected for a guess.
constexpr double kFacing = 0.5;
// Up to so many vertices the exact plan takes no time.
constexpr std::size_t kFewVertices = 1000;

/// Geodesic distances do not report a surface from its mirror image.
void turnCounterClockwise(const Mesh& surface, std::vector<Point2>& plan) {
  double area = 0.0;
  for (const Triangle& corner : surface.triangles) {
    const Point2 ab = plan[corner[1]] - plan[corner[0]];
    const Point2 ac = plan[corner[2]] - plan[corner[0]];
    area += ab.x() * ac.y() - ab.y() * ac.x();
  }
  if (area >= 0.0) return;
  for (Point2& place : plan) place.x() = -place.x();
}

bool isWithin(const Distortion& distortion, double tolerance) {
  return distortion.flipped == 0 && distortion.least_stretch >= 1.0 - tolerance &&
         distortion.greatest_stretch <= 1.0 + tolerance;
}

/// Whether a better plan may be within the tolerance where the coarse one is not. It mends single triangles
/// that are too small, mostly at borders.
bool isNearly(const Distortion& distortion, double tolerance) {
  return distortion.flipped == 0 && distortion.least_stretch >= 1.0 - 1.1 * tolerance &&
         distortion.greatest_stretch <= 1.0 + 2.0 * tolerance;
}

/// Unit vector: the mean direction in which the surface faces, and the least cosine to it.
struct Facing {
  Point3 direction = Point3::Zero();
  double least = -1.0;
};

Facing facingOf(const Mesh& surface) {
  std::vector<Point3> area;
  area.reserve(surface.triangles.size());
  Point3 sum = Point3::Zero();
  for (const Triangle& corner : surface.triangles) {
    const Point3& a = surface.vertices[corner[0]];
    area.emplace_back((surface.vertices[corner[1]] - a).cross(surface.vertices[corner[2]] - a));
    sum += area.back();
  }
  Facing facing;
  if (!(sum.norm() > 0.0)) return facing;
  facing.direction = sum.normalized();
  facing.least = 1.0;
  for (const Point3& one : area)
    if (const double norm = one.norm(); norm > 0.0)
      facing.least = std::min(facing.least, one.dot(facing.direction) / norm);
  return facing;
}

std::vector<Point2> project(const Mesh& surface, const Point3& direction) {
  const Point3 x = direction.unitOrthogonal();
  const Point3 y = direction.cross(x);
  std::vector<Point2> plan;
  plan.reserve(surface.vertices.size());
  for (const Point3& vertex : surface.vertices) plan.emplace_back(vertex.dot(x), vertex.dot(y));
  return plan;
}

/// Keeps the direction of each vertex from the middle one, and puts it as far away as it is over the surface.
std::vector<Point2> spread(std::vector<Point2> plan, const GeodesicDistances& geodesics) {
  Box2 box;
  for (const Point2& place : plan) box.include(place);
  const auto middle = std::min_element(plan.begin(), plan.end(), [&](const Point2& a, const Point2& b) {
    return (a - box.centre()).squaredNorm() < (b - box.centre()).squaredNorm();
  });
  const Point2 centre = *middle;
  const std::vector<double> distance = geodesics.from(static_cast<std::uint32_t>(middle - plan.begin()));
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const Point2 away = plan[i] - centre;
    if (const double norm = away.norm(); norm > 0.0)
      plan[i] = distance[i] / norm * away;
    else
      plan[i] = Point2::Zero();
  }
  return plan;
}

std::vector<Point2> scaleDistances(const Mesh& surface, TriangleFans fans,
                                   const FlatteningSettings& settings) {
  const GeodesicDistances geodesics(std::move(fans));
  const Landmarks landmarks =
      spreadLandmarks(geodesics, surface.vertices.size(), static_cast<std::size_t>(settings.landmarks));
  std::vector<Point2> plan = landmarkMds(landmarks);
  turnCounterClockwise(surface, plan);
  if (settings.method != FlatteningMethod::Stress) return plan;
  return lessenStress(std::move(plan), geodesics.fans(), landmarks);
}

std::vector<Point2> guessOf(const Mesh& surface, TriangleFans fans, const FlatteningSettings& settings) {
  const Facing facing = facingOf(surface);
  if (facing.least >= kFacing) return project(surface, facing.direction);
  if (facing.least > 0.0)
    return spread(project(surface, facing.direction), GeodesicDistances(std::move(fans)));
  return scaleDistances(surface, std::move(fans), settings);
}

std::vector<Point2> flattenArap(const Mesh& surface, const FlatteningSettings& settings) {
  TriangleFans fans = gatherFans(surface);
  if (auto plan = unfold(surface, fans, kUnrollsFlat))
    if (isWithin(measureDistortion(surface, *plan), kUnrollsFlat)) return std::move(*plan);
  std::vector<Point2> guess = guessOf(surface, std::move(fans), settings);
  const ArapEnergy energy(surface);
  if (surface.vertices.size() <= kFewVertices) return relaxArap(energy, std::move(guess));
  std::vector<Point2> plan = relaxCoarsely(energy, std::move(guess));
  const Distortion distortion = measureDistortion(surface, plan);
  if (isWithin(distortion, settings.tolerance) || !isNearly(distortion, settings.tolerance)) return plan;
  return relaxArap(energy, std::move(plan));
}

}  // namespace

std::vector<Point2> flatten(const Mesh& surface, const FlatteningSettings& settings) {
  if (surface.vertices.empty()) return {};
  if (settings.method == FlatteningMethod::Arap) return flattenArap(surface, settings);
  return scaleDistances(surface, gatherFans(surface), settings);
}

}  // namespace lamina
