// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/dynamics/sliding_mode.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "lamina/base/error.hpp"

namespace lamina {

void describe(SettingsSchema& schema, SlidingModeGains& gains) {
  schema.number("controller.k1", gains.k1, Bounds::above(0.0, 1e6), "Gain on the rate of the error.");
  schema.number("controller.k2", gains.k2, Bounds::above(0.0, 1e9), "Gain on the error.");
  schema.number("controller.k3", gains.k3, Bounds::above(0.0, 1e12), "Gain on the integral of the error.");
  schema.number("controller.reach_rad_s2", gains.reach, {0.0, 1e6},
                "Greatest acceleration with which it answers a distance from the sliding surface.");
  schema.number("controller.boundary_rad_s", gains.boundary, Bounds::above(0.0, 1e6),
                "Distance from the sliding surface at which that answer is greatest.");
}

CrankAngles slidingSurface(const SlidingModeGains& gains, const TrackingError& error) {
  return error.rate + gains.k1 * error.value + gains.k2 * error.integral + gains.k3 * error.double_integral;
}

CrankAngles askedAccelerations(const SlidingModeGains& gains, const TrackingError& error) {
  const CrankAngles saturated = (slidingSurface(gains, error) / gains.boundary).cwiseMax(-1.0).cwiseMin(1.0);
  return gains.k1 * error.rate + gains.k2 * error.value + gains.k3 * error.integral + gains.reach * saturated;
}

std::array<std::complex<double>, 3> poles(const SlidingModeGains& gains) {
  Eigen::Matrix3d companion;
  companion << -gains.k1, -gains.k2, -gains.k3, 1, 0, 0, 0, 1, 0;
  const Eigen::Vector3cd roots = companion.eigenvalues();
  std::array<std::complex<double>, 3> sorted = {roots[0], roots[1], roots[2]};
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return a.real() != b.real() ? a.real() < b.real() : a.imag() < b.imag();
  });
  return sorted;
}

void requireStable(const SlidingModeGains& gains) {
  const double worst = poles(gains)[2].real();
  if (worst < 0.0) return;
  throw InvalidConfig("the gains controller.k1, k2, k3 of " + std::to_string(gains.k1) + ", " +
                      std::to_string(gains.k2) + ", " + std::to_string(gains.k3) + " have a pole at " +
                      std::to_string(worst) + " 1/s; all must be negative");
}

}  // namespace lamina
