// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/plan_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {
namespace {

struct Segment {
  std::size_t curve = 0;
  std::size_t segment = 0;
  Point2 from = Point2::Zero();
  Point2 to = Point2::Zero();
};

/// A segment in a square of the plan that its box covers.
struct Covered {
  std::int64_t column = 0;
  std::int64_t row = 0;
  std::size_t segment = 0;
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

/// By squares as wide as the longest segment, so that none covers more than four.
std::vector<Covered> coveredSquares(const std::vector<Segment>& segments) {
  double cell_mm = 0.0;
  for (const Segment& segment : segments) cell_mm = std::max(cell_mm, (segment.to - segment.from).norm());
  std::vector<Covered> covered;
  if (cell_mm <= 0.0) return covered;
  const auto cell = [cell_mm](double position) {
    return static_cast<std::int64_t>(std::floor(position / cell_mm));
  };
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Point2 low = segments[s].from.cwiseMin(segments[s].to);
    const Point2 high = segments[s].from.cwiseMax(segments[s].to);
    for (std::int64_t column = cell(low.x()); column <= cell(high.x()); ++column)
      for (std::int64_t row = cell(low.y()); row <= cell(high.y()); ++row)
        covered.push_back({column, row, s});
  }
  std::sort(covered.begin(), covered.end(), [](const Covered& a, const Covered& b) {
    return std::tie(a.column, a.row, a.segment) < std::tie(b.column, b.row, b.segment);
  });
  return covered;
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
  const std::vector<Covered> covered = coveredSquares(segments);
  std::vector<PlanCrossing> crossings;
  for (std::size_t i = 0; i < covered.size(); ++i) {
    for (std::size_t j = i + 1;
         j < covered.size() && covered[j].column == covered[i].column && covered[j].row == covered[i].row;
         ++j)
      if (const auto found = crossingOf(segments[covered[i].segment], segments[covered[j].segment]))
        crossings.push_back(*found);
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
