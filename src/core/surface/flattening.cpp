// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/surface/flattening.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <utility>

#include "lamina/surface/plan_distortion.hpp"
#include "surface/classical_scaling.hpp"
#include "surface/rigid_plan.hpp"
#include "surface/stress_majorisation.hpp"
#include "surface/unfolding.hpp"

namespace lamina {
namespace {

// Surfaces that keep their lengths to this share when they are unrolled need no better plan.
constexpr double kUnrolls = 0.005;
// A surface that faces its mean direction so much (cosine of the angle) is projected for a guess.
constexpr double kFacing = 0.5;
// Up to so many vertices the exact plan takes no time.
constexpr std::size_t kFewVertices = 1000;
// A coarse plan whose stretch spreads this many times as far as allowed (in powers) is not worth a better
// one.
constexpr double kHopeless = 1.5;

/// Geodesic distances do not tell a surface from its mirror image.
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

bool isWithin(const PlanDistortion& distortion, double tolerance) {
  return distortion.flipped == 0 && distortion.least_stretch >= 1.0 - tolerance &&
         distortion.greatest_stretch <= 1.0 + tolerance;
}

bool isHopeless(const PlanDistortion& distortion, double tolerance) {
  const double spread = std::log(distortion.greatest_stretch / distortion.least_stretch);
  return distortion.flipped == 0 && spread > kHopeless * std::log((1.0 + tolerance) / (1.0 - tolerance));
}

/// The projection along the mean direction, if no triangle is steep to it.
std::optional<std::vector<Point2>> project(const Mesh& surface) {
  std::vector<Point3> area;
  area.reserve(surface.triangles.size());
  Point3 sum = Point3::Zero();
  for (const Triangle& corner : surface.triangles) {
    const Point3& a = surface.vertices[corner[0]];
    area.emplace_back((surface.vertices[corner[1]] - a).cross(surface.vertices[corner[2]] - a));
    sum += area.back();
  }
  if (!(sum.norm() > 0.0)) return std::nullopt;
  const Point3 direction = sum.normalized();
  for (const Point3& one : area)
    if (!(one.dot(direction) >= kFacing * one.norm())) return std::nullopt;
  const Point3 x = direction.unitOrthogonal();
  const Point3 y = direction.cross(x);
  std::vector<Point2> plan;
  plan.reserve(surface.vertices.size());
  for (const Point3& vertex : surface.vertices) plan.emplace_back(vertex.dot(x), vertex.dot(y));
  return plan;
}

std::vector<Point2> scaleDistances(const Mesh& surface, TriangleFans fans,
                                   const FlatteningSettings& settings) {
  const GeodesicDistances geodesics(std::move(fans));
  const Landmarks landmarks =
      spreadLandmarks(geodesics, surface.vertices.size(), static_cast<std::size_t>(settings.landmarks));
  std::vector<Point2> plan = classicalScaling(landmarks);
  turnCounterClockwise(surface, plan);
  if (settings.method != FlatteningMethod::Stress) return plan;
  return lessenStress(std::move(plan), geodesics.fans(), landmarks);
}

std::vector<Point2> flattenRigidly(const Mesh& surface, const FlatteningSettings& settings) {
  TriangleFans fans = gatherFans(surface);
  if (auto plan = unfold(surface, fans, kUnrolls))
    if (isWithin(measureDistortion(surface, *plan), kUnrolls)) return std::move(*plan);
  std::optional<std::vector<Point2>> guess = project(surface);
  if (!guess) guess = scaleDistances(surface, std::move(fans), settings);
  const RigidEnergy energy(surface);
  if (surface.vertices.size() <= kFewVertices) return relaxRigidly(energy, std::move(*guess));
  std::vector<Point2> plan = relaxCoarsely(energy, std::move(*guess));
  const PlanDistortion distortion = measureDistortion(surface, plan);
  if (isWithin(distortion, settings.tolerance) || isHopeless(distortion, settings.tolerance)) return plan;
  return relaxRigidly(energy, std::move(plan));
}

}  // namespace

std::vector<Point2> flatten(const Mesh& surface, const FlatteningSettings& settings) {
  if (surface.vertices.empty()) return {};
  if (settings.method == FlatteningMethod::Rigid) return flattenRigidly(surface, settings);
  return scaleDistances(surface, gatherFans(surface), settings);
}

}  // namespace lamina
