// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/curve_untangling.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "lamina/slicing/unsliceable.hpp"
#include "slicing/adapted/curve_length.hpp"
#include "slicing/adapted/mesh_region.hpp"
#include "slicing/adapted/plan_crossings.hpp"

namespace lamina {
namespace {

/// Points of a curve between two places of it where it crosses itself, taken round it.
struct PointLoop {
  std::size_t first = 0;
  std::size_t count = 0;
  double length_mm = 0.0;
  AdaptedCurve crossing;  // of one point
};

/// The shorter of the loops of a crossing; on an open curve there is but one.
PointLoop loopAt(const std::vector<AdaptedCurve>& curves, const CurveLength& length,
                 const PlanCrossing& crossing) {
  const AdaptedCurve& curve = curves.front();
  const auto lengthAt = [&](const CrossedPlace& place) {
    return length.at({place.segment, place.fraction, Point3::Zero(), 0.0});
  };
  const double between = lengthAt(crossing.second) - lengthAt(crossing.first);
  const std::size_t inside = crossing.second.segment - crossing.first.segment;
  PointLoop loop{crossing.first.segment + 1, inside, between, pointAt(curves, crossing)};
  if (!curve.is_closed || 2.0 * between <= length.total()) return loop;
  loop.first = (crossing.second.segment + 1) % curve.points.size();
  loop.count = curve.points.size() - inside;
  loop.length_mm = length.total() - between;
  return loop;
}

std::vector<PointLoop> smallLoops(const std::vector<AdaptedCurve>& curves, double most_mm) {
  std::vector<PointLoop> loops;
  const std::vector<PlanCrossing> crossings = planCrossings(curves);
  if (crossings.empty()) return loops;
  const CurveLength length(curves.front());
  for (const PlanCrossing& crossing : crossings) {
    PointLoop loop = loopAt(curves, length, crossing);
    if (loop.length_mm <= most_mm) loops.push_back(std::move(loop));
  }
  // Those that enclose others first: with them these are gone.
  std::stable_sort(loops.begin(), loops.end(),
                   [](const PointLoop& a, const PointLoop& b) { return a.length_mm > b.length_mm; });
  return loops;
}

AdaptedCurve without(const AdaptedCurve& curve, const std::vector<PointLoop>& loops) {
  const std::size_t count = curve.points.size();
  std::vector<bool> is_left_out(count, false);
  std::vector<const AdaptedCurve*> instead(count, nullptr);
  for (const PointLoop& loop : loops) {
    bool is_free = true;
    for (std::size_t i = 0; i < loop.count; ++i) is_free = is_free && !is_left_out[(loop.first + i) % count];
    if (!is_free) continue;
    for (std::size_t i = 0; i < loop.count; ++i) is_left_out[(loop.first + i) % count] = true;
    instead[loop.first % count] = &loop.crossing;
  }
  AdaptedCurve kept;
  kept.is_closed = curve.is_closed;
  for (std::size_t i = 0; i < count; ++i) {
    if (is_left_out[i] && instead[i] == nullptr) continue;
    const AdaptedCurve& source = is_left_out[i] ? *instead[i] : curve;
    const std::size_t at = is_left_out[i] ? 0 : i;
    kept.points.push_back(source.points[at]);
    kept.axis.push_back(source.axis[at]);
    kept.height_mm.push_back(source.height_mm[at]);
  }
  return kept;
}

}  // namespace

AdaptedCurve withoutSmallLoops(AdaptedCurve curve, double most_mm) {
  std::vector<AdaptedCurve> curves{std::move(curve)};
  // Each round leaves fewer points, as a loop has two at least.
  for (;;) {
    const std::vector<PointLoop> loops = smallLoops(curves, most_mm);
    if (loops.empty()) return std::move(curves.front());
    curves.front() = without(curves.front(), loops);
  }
}

void requireNoCrossing(const std::vector<AdaptedCurve>& curves, std::size_t layer, const Mesh& mesh) {
  const std::vector<PlanCrossing> crossings = planCrossings(curves);
  if (crossings.empty()) return;
  const Point3 at = pointAt(curves, crossings.front()).points.front();
  char message[320];
  std::snprintf(message, sizeof message,
                "the wall of adapted layer %zu crosses itself, seen from above, at (%.2f, %.2f, %.2f) mm; "
                "expected walls whose lean changes gently along a loop",
                layer, at.x(), at.y(), at.z());
  constexpr double kAround = 1.0;  // mm
  throw Unsliceable(message, facesNear(mesh, at, kAround));
}

}  // namespace lamina
