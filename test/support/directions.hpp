// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina::test {

/// A number of [low, high] by rapidcheck.
inline double anyNumber(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
}

/// A direction whose angle from straight down is at most `max_tilt_deg`.
inline Point3 anyToolAxis(double max_tilt_deg) {
  const double tilt = anyNumber(0.0, max_tilt_deg) * M_PI / 180.0;
  const double heading = anyNumber(0.0, 2.0 * M_PI);
  return {std::sin(tilt) * std::cos(heading), std::sin(tilt) * std::sin(heading), -std::cos(tilt)};
}

inline std::vector<Point3> anyToolAxes(std::size_t count, double max_tilt_deg) {
  std::vector<Point3> tool_axes;
  while (tool_axes.size() < count) tool_axes.push_back(anyToolAxis(max_tilt_deg));
  return tool_axes;
}

/// Angle between two unit vectors by their chord [deg].
inline double chordAngleDeg(const Point3& a, const Point3& b) {
  return 2.0 * std::asin(std::min(1.0, 0.5 * (a - b).norm())) * 180.0 / M_PI;
}

}  // namespace lamina::test
