// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/normal_loop.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

constexpr double kSameNormal = 1e-9;

Polygon withoutRepeats(const Polygon& outline) {
  Polygon points;
  for (const Point2& point : outline)
    if (points.empty() || (point - points.back()).norm() >= kSameNormal) points.push_back(point);
  while (points.size() > 1 && (points.front() - points.back()).norm() < kSameNormal) points.pop_back();
  return points;
}

/// Material lies to the left of an outline.
Point2 leftBetween(const Point2& from, const Point2& to) { return leftOf((to - from).normalized()); }

/// Between two unit vectors; the first one if they cancel out.
Point2 between(const Point2& a, const Point2& b, double part) {
  const Point2 sum = (1.0 - part) * a + part * b;
  return sum.norm() < kSameNormal ? a : Point2(sum.normalized());
}

}  // namespace

NormalLoop withNormals(const Polygon& outline, double longest_step_mm) {
  const Polygon corners = withoutRepeats(outline);
  const std::size_t count = corners.size();
  if (count < 3) return {};
  const auto next = [&](std::size_t i) { return i + 1 < count ? i + 1 : 0; };
  std::vector<Point2> normals(count);
  for (std::size_t i = 0; i < count; ++i)
    normals[next(i)] = between(leftBetween(corners[i], corners[next(i)]),
                               leftBetween(corners[next(i)], corners[next(next(i))]), 0.5);
  NormalLoop loop;
  for (std::size_t i = 0; i < count; ++i) {
    const Point2 along = corners[next(i)] - corners[i];
    const int parts = std::max(1, static_cast<int>(std::ceil(along.norm() / longest_step_mm - kSameNormal)));
    for (int k = 0; k < parts; ++k) {
      const double part = static_cast<double>(k) / parts;
      loop.points.emplace_back(corners[i] + part * along);
      loop.inward.push_back(between(normals[i], normals[next(i)], part));
    }
  }
  return loop;
}

Polygon movedInwards(const NormalLoop& loop, double distance_mm) {
  Polygon moved = loop.points;
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += distance_mm * loop.inward[i];
  return moved;
}

}  // namespace lamina
