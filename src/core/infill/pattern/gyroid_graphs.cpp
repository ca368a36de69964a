// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/pattern/gyroid_graphs.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

GyroidGraphs::GyroidGraphs(double z) : sin_z_(std::sin(z)), cos_z_(std::cos(z)) {}

bool GyroidGraphs::isOverX() const { return std::abs(sin_z_) <= std::abs(cos_z_); }

double GyroidGraphs::at(double t, int branch) const {
  // The angle does not jump where the coefficient that keeps its sign is held positive.
  const double sign = std::copysign(1.0, isOverX() ? cos_z_ : sin_z_);
  const double a = sign * (isOverX() ? std::sin(t) : sin_z_);
  const double b = sign * (isOverX() ? cos_z_ : std::cos(t));
  const double c = sign * (isOverX() ? sin_z_ * std::cos(t) : cos_z_ * std::sin(t));
  const double ratio = std::clamp(-c / std::hypot(a, b), -1.0, 1.0);
  return std::atan2(b, a) + branch * std::acos(ratio);
}

}  // namespace lamina
