// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/surface/flattening.hpp"

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

bool isTrue(const Mesh& surface, const std::vector<Point2>& plan) {
  const PlanDistortion distortion = measureDistortion(surface, plan);
  return distortion.flipped == 0 && distortion.least_stretch > 1.0 - kUnrolls &&
         distortion.greatest_stretch < 1.0 + kUnrolls;
}

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

}  // namespace

std::vector<Point2> flatten(const Mesh& surface, const FlatteningSettings& settings) {
  if (surface.vertices.empty()) return {};
  TriangleFans fans = gatherFans(surface);
  if (settings.method == FlatteningMethod::Rigid)
    if (auto plan = unfold(surface, fans, kUnrolls); plan && isTrue(surface, *plan)) return std::move(*plan);
  const GeodesicDistances geodesics(std::move(fans));
  const Landmarks landmarks =
      spreadLandmarks(geodesics, surface.vertices.size(), static_cast<std::size_t>(settings.landmarks));
  std::vector<Point2> plan = classicalScaling(landmarks);
  turnCounterClockwise(surface, plan);
  if (settings.method == FlatteningMethod::Rigid) return relaxRigidly(surface, std::move(plan));
  if (settings.method == FlatteningMethod::Stress)
    return lessenStress(std::move(plan), geodesics.fans(), landmarks);
  return plan;
}

}  // namespace lamina
