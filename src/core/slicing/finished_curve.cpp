// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/finished_curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lamina {
namespace {

constexpr double kCoincident = 1e-6;  // mm

void append(AdaptedCurve& curve, const Point3& point, const Point3& axis, double height_mm) {
  curve.points.push_back(point);
  curve.axis.push_back(axis);
  curve.height_mm.push_back(height_mm);
}

AdaptedCurve withoutCoincident(const AdaptedCurve& curve) {
  AdaptedCurve kept;
  kept.is_closed = curve.is_closed;
  for (std::size_t i = 0; i < curve.points.size(); ++i)
    if (kept.points.empty() || (curve.points[i] - kept.points.back()).norm() > kCoincident)
      append(kept, curve.points[i], curve.axis[i], curve.height_mm[i]);
  while (kept.is_closed && kept.points.size() > 1 &&
         (kept.points.back() - kept.points.front()).norm() <= kCoincident) {
    kept.points.pop_back();
    kept.axis.pop_back();
    kept.height_mm.pop_back();
  }
  return kept;
}

/// Sums run along the curve, so that a wide window costs no more than a narrow one.
std::vector<Point3> averaged(const std::vector<Point3>& points, bool is_closed, std::size_t half) {
  const std::size_t count = points.size();
  std::vector<Point3> sums(count + 1, Point3::Zero());
  for (std::size_t i = 0; i < count; ++i) sums[i + 1] = sums[i] + points[i];
  const auto sumBefore = [&](std::size_t end) {
    return Point3(static_cast<double>(end / count) * sums[count] + sums[end % count]);
  };
  const std::size_t rounds = (half / count + 1) * count;
  std::vector<Point3> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t reach = is_closed ? half : std::min({half, i, count - 1 - i});
    result[i] = (sumBefore(rounds + i + reach + 1) - sumBefore(rounds + i - reach)) /
                static_cast<double>(2 * reach + 1);
  }
  return result;
}

AdaptedCurve filled(const AdaptedCurve& curve, double step_mm) {
  AdaptedCurve dense;
  dense.is_closed = curve.is_closed;
  const std::size_t count = curve.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const bool is_end = next == 0 && !curve.is_closed;
    const double length = is_end ? 0.0 : (curve.points[next] - curve.points[i]).norm();
    const double pieces = std::max(1.0, std::ceil(length / step_mm - 1e-9));
    for (double piece = 0.0; piece < pieces; ++piece) {
      const double share = piece / pieces;
      append(dense, (1.0 - share) * curve.points[i] + share * curve.points[next],
             ((1.0 - share) * curve.axis[i] + share * curve.axis[next]).normalized(),
             (1.0 - share) * curve.height_mm[i] + share * curve.height_mm[next]);
    }
  }
  return dense;
}

}  // namespace

AdaptedCurve finishedCurve(const AdaptedCurve& curve, double step_mm, int smoothing_window) {
  AdaptedCurve finished = withoutCoincident(curve);
  if (smoothing_window > 1)
    finished.points =
        averaged(finished.points, finished.is_closed, static_cast<std::size_t>(smoothing_window / 2));
  return filled(finished, step_mm);
}

}  // namespace lamina
