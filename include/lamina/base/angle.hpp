// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace lamina {

inline constexpr double kDegree = M_PI / 180.0;            ///< one degree [rad]
inline constexpr double kDegreesPerRadian = 180.0 / M_PI;  ///< one radian [deg]

/// An angle in radians. May differ from `degrees * kDegree` in the last bit.
constexpr double toRadians(double degrees) { return degrees * M_PI / 180.0; }

/// An angle in degrees. May differ from `radians * kDegreesPerRadian` in the last bit.
constexpr double toDegrees(double radians) { return radians * 180.0 / M_PI; }

/// The same angle in (-pi, pi] [rad].
inline double wrappedRadians(double angle) {
  const double turned = std::remainder(angle, 2.0 * M_PI);
  return turned <= -M_PI ? M_PI : turned;
}

/// The same angle in (-180, 180] [deg].
inline double wrappedDegrees(double degrees) {
  const double turned = std::remainder(degrees, 360.0);
  return turned <= -180.0 ? 180.0 : turned;
}

}  // namespace lamina
