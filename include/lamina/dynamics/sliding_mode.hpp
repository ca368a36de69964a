// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <complex>

#include "lamina/base/settings_schema.hpp"
#include "lamina/kinematics/platform/rus_platform.hpp"

namespace lamina {

/// Gains of the sliding-mode controller [Guacheta2021, eq. 1.4 to 1.9 and table 1-2]: with
/// the error e = reference - crank, the surface is sigma = e' + k1 e + k2 int e + k3 int int e, and the
/// torque is gravity + coriolis + mass (k1 e' + k2 e + k3 int e + reach sat(sigma / boundary)).
struct SlidingModeGains {
  double k1 = 64.4;       ///< [1/s]
  double k2 = 1019.1;     ///< [1/s²]
  double k3 = 7945.8;     ///< [1/s³]
  double reach = 30.0;    ///< L, not published: greatest acceleration it can answer for [rad/s²]
  double boundary = 0.3;  ///< not published: of sigma, within which the answer is linear [rad/s]
};

/// Adds the keys controller.*.
void describe(SettingsSchema& schema, SlidingModeGains& gains);

/// The errors of the six cranks.
struct TrackingError {
  CrankAngles value = CrankAngles::Zero();            ///< e [rad]
  CrankAngles rate = CrankAngles::Zero();             ///< e' [rad/s]
  CrankAngles integral = CrankAngles::Zero();         ///< [rad s]
  CrankAngles double_integral = CrankAngles::Zero();  ///< [rad s²]
};

/// Distance from the sliding surface [rad/s].
CrankAngles slidingSurface(const SlidingModeGains& gains, const TrackingError& error);

/// The accelerations that the controller asks of the cranks [rad/s²]; the torque is that of a platform which
/// moves so.
CrankAngles askedAccelerations(const SlidingModeGains& gains, const TrackingError& error);

/// Roots of s³ + k1 s² + k2 s + k3, how the error fades on the surface [1/s]; by real part.
std::array<std::complex<double>, 3> poles(const SlidingModeGains& gains);

/// @throws InvalidConfig if the error would not fade: a pole without negative real part
void requireStable(const SlidingModeGains& gains);

}  // namespace lamina
