// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina::test {

struct Spacing {
  double least_mm = std::numeric_limits<double>::infinity();
  double greatest_mm = 0.0;
};

/// Distance in space from a point to the nearest point of a path [mm].
inline double distanceTo(const Path& path, const Point3& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const Point3& from = path.points[m];
    const Point3 along = path.points[path.motionEnd(m)] - from;
    const double squared = along.squaredNorm();
    const double part = squared > 0.0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (from + part * along - point).norm());
  }
  return nearest;
}

/// How far a path is from its neighbour, measured in space at points every tenth of a millimetre: for
/// spacings that are small against the radius of the layer the chord is the arc.
inline Spacing spacingBetween(const Path& path, const Path& neighbour) {
  Spacing spacing;
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const Point3& from = path.points[m];
    const Point3 along = path.points[path.motionEnd(m)] - from;
    const int count = std::max(1, static_cast<int>(std::ceil(along.norm() / 0.1)));
    for (int k = 0; k <= count; ++k) {
      const double distance = distanceTo(neighbour, from + along * k / count);
      spacing.least_mm = std::min(spacing.least_mm, distance);
      spacing.greatest_mm = std::max(spacing.greatest_mm, distance);
    }
  }
  return spacing;
}

}  // namespace lamina::test
