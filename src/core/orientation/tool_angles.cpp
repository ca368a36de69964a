// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/tool_angles.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

ToolAngles toolAngles(const Point3& tool_axis) {
  const double sideways = std::hypot(tool_axis.x(), tool_axis.z());
  // By both legs: near y the arcsine alone would lose half of the digits.
  const double alpha = std::atan2(tool_axis.y(), sideways);
  return {alpha, sideways == 0.0 ? 0.0 : std::atan2(-tool_axis.x(), -tool_axis.z())};
}

Point3 toolAxisOf(const ToolAngles& angles) {
  return {-std::cos(angles.alpha) * std::sin(angles.beta), std::sin(angles.alpha),
          -std::cos(angles.alpha) * std::cos(angles.beta)};
}

}  // namespace lamina
