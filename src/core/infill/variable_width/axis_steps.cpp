// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/variable_width/axis_steps.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

AxisPoint between(const AxisPoint& from, const AxisPoint& to, double t) {
  return {from.point + t * (to.point - from.point), from.radius_mm + t * (to.radius_mm - from.radius_mm)};
}

std::vector<AxisPoint> inRadiusSteps(const std::vector<AxisPoint>& points, double step_mm) {
  std::vector<AxisPoint> result = {points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double change = std::abs(points[i].radius_mm - points[i - 1].radius_mm);
    const int count = std::max(1, static_cast<int>(std::ceil(change / step_mm)));
    for (int k = 1; k <= count; ++k)
      result.push_back(between(points[i - 1], points[i], static_cast<double>(k) / count));
  }
  return result;
}

}  // namespace lamina
