// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/gcode/arc_fit.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

constexpr std::size_t kFewestChords = 3;
constexpr double kLeastRadius = 0.5;         // mm
constexpr double kGreatestRadius = 2000.0;   // mm
constexpr double kLeastSweep = M_PI / 36.0;  // 5 deg
constexpr double kGreatestSweep = M_PI + 1e-6;
constexpr double kShortestSpan = 1e-3;  // mm: last decimal of programs

/// Centre of the circle through both ends that fits the points between them best. Its distance t from the
/// middle of the ends along their normal u makes |p - m|² - d² = 2 t (p - m) u for each point p on the
/// circle.
std::optional<Point2> fittedCentre(const std::vector<Point2>& points, std::size_t first, std::size_t last) {
  const Point2 middle = 0.5 * (points[first] + points[last]);
  const Point2 half = points[last] - middle;
  const double span = half.norm();
  if (span < kShortestSpan) return std::nullopt;
  const Point2 normal = leftOf(half) / span;
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t i = first + 1; i < last; ++i) {
    const Point2 from_middle = points[i] - middle;
    const double across = from_middle.dot(normal);
    products += (from_middle.squaredNorm() - span * span) * across;
    squares += across * across;
  }
  if (squares <= kShortestSpan * kShortestSpan * 1e-6) return std::nullopt;
  return Point2(middle + products / (2.0 * squares) * normal);
}

/// The arc over the points, if it is one.
std::optional<FittedArc> arcOver(const std::vector<Point2>& points, std::size_t first, std::size_t last,
                                 double tolerance_mm) {
  const std::optional<Point2> centre = fittedCentre(points, first, last);
  if (!centre) return std::nullopt;
  const double radius = (points[first] - *centre).norm();
  if (radius < kLeastRadius || radius > kGreatestRadius) return std::nullopt;
  const auto lies_on = [&](const Point2& point) {
    return std::abs((point - *centre).norm() - radius) <= tolerance_mm;
  };
  double sweep = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    const Point2 from = points[i] - *centre;
    const Point2 to = points[i + 1] - *centre;
    const double step = turn(from, to);
    if (step == 0.0 || step * sweep < 0.0) return std::nullopt;
    sweep += step;
    if (!lies_on(points[i]) || !lies_on(0.5 * (points[i] + points[i + 1]))) return std::nullopt;
  }
  if (std::abs(sweep) > kGreatestSweep) return std::nullopt;
  return FittedArc{last, *centre, std::abs(sweep),
                   sweep > 0.0 ? ArcDirection::CounterClockwise : ArcDirection::Clockwise};
}

}  // namespace

std::optional<FittedArc> longestArc(const std::vector<Point2>& points, std::size_t first, std::size_t last,
                                    double tolerance_mm) {
  std::optional<FittedArc> longest;
  std::size_t too_many = last - first + 1;
  for (std::size_t chords = kFewestChords; chords < too_many;) {
    const std::optional<FittedArc> arc = arcOver(points, first, first + chords, tolerance_mm);
    if (arc)
      longest = arc;
    else
      too_many = chords;
    const std::size_t held = longest ? longest->last - first : kFewestChords;
    const bool has_failed = too_many != last - first + 1;
    chords = has_failed ? (held + too_many) / 2 : std::min(2 * held, last - first);
    if (chords <= held) break;
  }
  return longest && longest->sweep_rad > kLeastSweep ? longest : std::nullopt;
}

}  // namespace lamina
