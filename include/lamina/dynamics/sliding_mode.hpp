// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <complex>

#include "lamina/base/settings_schema.hpp"
#include "lamina/kinematics/platform/rus_platform.hpp"

namespace lamina {

/// Gains of the sliding-mode controller [Guacheta2021, eq. 1.4 to 1.9 and table 1-2]. With the error e =
/// reference - crank, the sliding surface is sigma = e' + k1 e + k2 int e + k3 int int e = 0, and the torque
/// is gravity + coriolis + mass (k1 e' + k2 e + k3 int e + reach sat(sigma / boundary)).
struct SlidingModeGains {
  double k1 = 64.4;    ///< [1/s]
  double k2 = 1019.1;  ///< [1/s²]
  double k3 = 7945.8;  ///< [1/s³]
  /// Greatest disturbance, as an acceleration, that the controller compensates for [rad/s²]; L, not
  /// published.
  double reach = 30.0;
  /// Magnitude of sigma within which the response to it is linear [rad/s]; not published.
  double boundary = 0.3;
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

/// Value of sigma for each crank [rad/s]; 0 on the sliding surface.
CrankAngles slidingSurface(const SlidingModeGains& gains, const TrackingError& error);

/// The accelerations that the controller demands of the cranks [rad/s²]. The controller's torque gives a
/// platform without friction these accelerations.
CrankAngles askedAccelerations(const SlidingModeGains& gains, const TrackingError& error);

/// Poles of the error on the sliding surface [1/s]: the roots of s³ + k1 s² + k2 s + k3, ascending by real
/// part.
std::array<std::complex<double>, 3> poles(const SlidingModeGains& gains);

/// Checks that the error decays on the sliding surface.
/// @throws InvalidConfig if a pole has no negative real part
void requireStable(const SlidingModeGains& gains);

}  // namespace lamina
