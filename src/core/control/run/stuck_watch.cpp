// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/stuck_watch.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace lamina {
namespace {

constexpr double kStillVariance = 1e-9;  // mm²

bool isNumber(const Point3& point) { return point.allFinite() && !point.isZero(0.0); }

/// Variance of two profiles about their mean, at the point where it is greatest, or at the first one that is
/// not still; infinite where a point comes or goes, 0 if neither has any.
double greatestVariance(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double greatest = 0.0;
  for (std::size_t i = 0; i < a.size() && greatest < kStillVariance; ++i) {
    if (isNumber(a[i]) != isNumber(b[i])) return std::numeric_limits<double>::infinity();
    if (isNumber(a[i])) greatest = std::max(greatest, 0.25 * (a[i] - b[i]).squaredNorm());
  }
  return greatest;
}

}  // namespace

/// That of the profile that is most like it, which is put to the end; infinite if there is none.
double StuckWatch::leastVariance(const std::vector<Point3>& points) {
  double least = std::numeric_limits<double>::infinity();
  auto alike = last_.end();
  for (auto each = last_.begin(); each != last_.end(); ++each) {
    const double variance = greatestVariance(points, *each);
    if (!(variance < least)) continue;
    least = variance;
    alike = each;
  }
  if (least < kStillVariance) std::rotate(alike, alike + 1, last_.end());
  return least;
}

void StuckWatch::remember(const std::vector<Point3>& points) {
  if (last_.size() < kRemembered)
    last_.emplace_back();
  else
    std::rotate(last_.begin(), last_.begin() + 1, last_.end());
  last_.back() = points;
}

void StuckWatch::see(const std::vector<Point3>& points) {
  if (points.empty()) return;
  const bool is_none = std::none_of(points.begin(), points.end(), isNumber);
  const double variance = is_none ? 0.0 : leastVariance(points);
  const bool is_still = variance < kStillVariance;
  // The first ones of several sensors are news each, and the next ones of all are not.
  profiles_ = is_still ? profiles_ + 1 : 1;
  variance_mm2_ = is_still ? std::max(variance_mm2_, variance) : 0.0;
  if (!is_still) remember(points);
}

}  // namespace lamina
