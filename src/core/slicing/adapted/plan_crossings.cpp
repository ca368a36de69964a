// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/plan_crossings.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"
#include "geometry/spatial/box_cells.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {
namespace {

constexpr double kLeastShare = 1e-6;  // of the plan that a cell measures

struct Segment {
  std::size_t curve = 0;
  std::size_t segment = 0;
  Point2 from = Point2::Zero();
  Point2 to = Point2::Zero();
};

std::vector<Segment> planSegmentsOf(const std::vector<AdaptedCurve>& curves) {
  std::vector<Segment> segments;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const std::vector<Point3>& points = curves[c].points;
    for (std::size_t i = 0; i + (curves[c].is_closed ? 0 : 1) < points.size(); ++i)
      segments.push_back({c, i, points[i].head<2>(), points[(i + 1) % points.size()].head<2>()});
  }
  return segments;
}

/// In cells as wide as the longest segment, so that none lies in more than four.
BoxCells cellsOf(const std::vector<Segment>& segments) {
  Box3 all;
  double longest_mm = 0.0;
  std::vector<Box3> boxes(segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    for (const Point2& end : {segments[s].from, segments[s].to}) boxes[s].include({end.x(), end.y(), 0.0});
    all.include(boxes[s].low);
    all.include(boxes[s].high);
    longest_mm = std::max(longest_mm, (segments[s].to - segments[s].from).norm());
  }
  if (longest_mm <= 0.0) return {};
  const double cell_mm = std::max(longest_mm, kLeastShare * all.size().maxCoeff());
  return BoxCells({CellKind::Cubes, all, cell_mm}, [&](const auto& put) {
    for (std::uint32_t s = 0; s < boxes.size(); ++s) put(s, boxes[s]);
  });
}

std::optional<PlanCrossing> crossingOf(const Segment& a, const Segment& b) {
  const double a_from = side(b.from, b.to, a.from);
  const double a_to = side(b.from, b.to, a.to);
  const double b_from = side(a.from, a.to, b.from);
  const double b_to = side(a.from, a.to, b.to);
  if (!(a_from * a_to < 0.0) || !(b_from * b_to < 0.0)) return std::nullopt;
  return PlanCrossing{{a.curve, a.segment, a_from / (a_from - a_to)},
                      {b.curve, b.segment, b_from / (b_from - b_to)}};
}

auto orderOf(const PlanCrossing& crossing) {
  return std::make_tuple(crossing.first.curve, crossing.first.segment, crossing.second.curve,
                         crossing.second.segment);
}

}  // namespace

std::vector<PlanCrossing> planCrossings(const std::vector<AdaptedCurve>& curves) {
  const std::vector<Segment> segments = planSegmentsOf(curves);
  const BoxCells cells = cellsOf(segments);
  std::vector<PlanCrossing> crossings;
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    const BoxCells::Numbers in = cells.in(cell);
    for (const std::uint32_t* a = in.begin(); a != in.end(); ++a)
      for (const std::uint32_t* b = a + 1; b != in.end(); ++b)
        if (const auto found = crossingOf(segments[*a], segments[*b])) crossings.push_back(*found);
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const PlanCrossing& a, const PlanCrossing& b) { return orderOf(a) < orderOf(b); });
  crossings.erase(
      std::unique(crossings.begin(), crossings.end(),
                  [](const PlanCrossing& a, const PlanCrossing& b) { return orderOf(a) == orderOf(b); }),
      crossings.end());
  return crossings;
}

AdaptedCurve pointAt(const std::vector<AdaptedCurve>& curves, const PlanCrossing& crossing) {
  Point3 point = Point3::Zero();
  Point3 axis = Point3::Zero();
  double height_mm = 0.0;
  for (const CrossedPlace& place : {crossing.first, crossing.second}) {
    const AdaptedCurve& curve = curves[place.curve];
    const std::size_t next = (place.segment + 1) % curve.points.size();
    const double share = 0.5 * place.fraction;
    const double rest = 0.5 - share;
    point += rest * curve.points[place.segment] + share * curve.points[next];
    axis += rest * curve.axis[place.segment] + share * curve.axis[next];
    height_mm += rest * curve.height_mm[place.segment] + share * curve.height_mm[next];
  }
  return {false, {point}, {axis.normalized()}, {height_mm}};
}

}  // namespace lamina
