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

/// Variance of two profiles about their mean, at the point where it is greatest; infinite where a point comes
/// or goes, 0 if neither has any.
double greatestVariance(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double greatest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (isNumber(a[i]) != isNumber(b[i])) return std::numeric_limits<double>::infinity();
    if (isNumber(a[i])) greatest = std::max(greatest, 0.25 * (a[i] - b[i]).squaredNorm());
  }
  return greatest;
}

}  // namespace

void StuckWatch::see(const std::vector<Point3>& points) {
  if (points.empty()) return;
  const bool is_none = std::none_of(points.begin(), points.end(), isNumber);
  const double variance = is_none ? 0.0 : greatestVariance(points, last_);
  const bool is_still = variance < kStillVariance;
  profiles_ = is_still ? profiles_ + 1 : 1;
  variance_mm2_ = is_still ? std::max(variance_mm2_, variance) : 0.0;
  last_ = points;
}

}  // namespace lamina
