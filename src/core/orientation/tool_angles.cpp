// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/tool_angles.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

ToolAngles toolAngles(const Point3& jet) {
  const double sideways = std::hypot(jet.x(), jet.z());
  // By both legs: near y the arcsine alone would lose half of the digits.
  const double alpha = std::atan2(jet.y(), sideways);
  return {alpha, sideways == 0.0 ? 0.0 : std::atan2(-jet.x(), -jet.z())};
}

Point3 jetOf(const ToolAngles& angles) {
  return {-std::cos(angles.alpha) * std::sin(angles.beta), std::sin(angles.alpha),
          -std::cos(angles.alpha) * std::cos(angles.beta)};
}

}  // namespace lamina
