// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/adapted/finished_curve.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/geometry/moving_average.hpp"

namespace lamina {
namespace {

constexpr double kCoincident = 1e-6;  // mm
constexpr double kOnTheWay = 1e-3;    // mm
constexpr double kClose = 0.1;        // of a step

void append(AdaptedCurve& curve, const Point3& point, const Point3& axis, double height_mm) {
  curve.points.push_back(point);
  curve.axis.push_back(axis);
  curve.height_mm.push_back(height_mm);
}

double distanceFromChord(const Point3& point, const Point3& from, const Point3& to) {
  const Point3 along = to - from;
  const double length = along.norm();
  if (length <= kCoincident) return (point - from).norm();
  return along.cross(point - from).norm() / length;
}

/// Whether the curve does without a point: it is close to the one before it and on the way to the next.
bool isSpare(const Point3& before, const Point3& point, const Point3& next, double close_mm) {
  const double distance = (point - before).norm();
  return distance <= kCoincident ||
         (distance < close_mm && distanceFromChord(point, before, next) <= kOnTheWay);
}

AdaptedCurve withoutSpare(const AdaptedCurve& curve, double close_mm) {
  AdaptedCurve kept;
  kept.is_closed = curve.is_closed;
  const std::size_t count = curve.points.size();
  append(kept, curve.points[0], curve.axis[0], curve.height_mm[0]);
  for (std::size_t i = 1; i < count; ++i) {
    const bool is_end = i + 1 == count && !curve.is_closed;
    const Point3& next = curve.points[(i + 1) % count];
    if (is_end || !isSpare(kept.points.back(), curve.points[i], next, close_mm))
      append(kept, curve.points[i], curve.axis[i], curve.height_mm[i]);
  }
  if (kept.is_closed && kept.points.size() > 3 &&
      (kept.points.back() - kept.points.front()).norm() <= kCoincident) {
    kept.points.pop_back();
    kept.axis.pop_back();
    kept.height_mm.pop_back();
  }
  return kept;
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
  AdaptedCurve finished = withoutSpare(curve, kClose * step_mm);
  if (smoothing_window > 1)
    finished.points = movingAverages(finished.points, finished.is_closed ? Course::Closed : Course::Open,
                                     static_cast<std::size_t>(smoothing_window / 2));
  return filled(finished, step_mm);
}

}  // namespace lamina
