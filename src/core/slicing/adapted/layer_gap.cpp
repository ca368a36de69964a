// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/layer_gap.hpp"

#include <algorithm>
#include <cstdio>

#include "lamina/slicing/unsliceable.hpp"
#include "slicing/adapted/mesh_region.hpp"

namespace lamina {
namespace {

constexpr double kMostHeights = 2.0;

}  // namespace

void requireNoGap(const AdaptedCurve& curve, const PlacedCurve& below, const GapLimit& limit,
                  std::size_t layer, const Mesh& mesh) {
  const CurvePlaces places(curve.points, curve.is_closed);
  double greatest = 0.0;
  Point3 at = Point3::Zero();
  for (const Point3& point : below.curve.points) {
    const double distance = places.nearest(point).distance_mm;
    if (distance > greatest) at = point;
    greatest = std::max(greatest, distance);
  }
  if (greatest <= kMostHeights * limit.height_mm + limit.step_mm) return;
  char message[320];
  std::snprintf(
      message, sizeof message,
      "adapted layer %zu leaves a gap of %.2f mm over (%.2f, %.2f, %.2f) mm where layers are %.2f mm high; "
      "expected walls whose lean changes gently along a loop",
      layer, greatest, at.x(), at.y(), at.z(), limit.height_mm);
  throw Unsliceable(message, facesNear(mesh, at, greatest));
}

}  // namespace lamina
