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

}  // namespace lamina
