// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/dynamics/sliding_mode.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

/// A real zero of s^3 + k1 s^2 + k2 s + k3 by bisection: below zero, since k3 is positive.
double realPole(const SlidingModeGains& gains) {
  constexpr int kHalvings = 200;  // from Cauchy's bound on all zeros to far below the least of them
  double low = -(1.0 + std::max({gains.k1, gains.k2, gains.k3}));
  double high = 0.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2.0;
    const bool is_below = ((middle + gains.k1) * middle + gains.k2) * middle + gains.k3 < 0.0;
    (is_below ? low : high) = middle;
  }
  return high;
}

/// Both zeros of s^2 + b s + c, without the difference of numbers that are nearly equal.
std::array<std::complex<double>, 2> zeros(double b, double c) {
  const std::complex<double> root = std::sqrt(std::complex<double>(b * b / 4.0 - c));
  if (root.imag() != 0.0) return {-b / 2.0 - root, -b / 2.0 + root};
  const double far = -b / 2.0 - std::copysign(root.real(), b);
  return {far, far == 0.0 ? 0.0 : c / far};
}

}  // namespace

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
  const double real = realPole(gains);
  // The zero is divided out from the end that loses no digits: (s - real) (s^2 + b s + c).
  const bool is_far = -real * real * real > gains.k3;
  const double c = is_far ? -gains.k3 / real : gains.k2 + real * (gains.k1 + real);
  const double b = is_far ? (c - gains.k2) / real : gains.k1 + real;
  const auto [first, second] = zeros(b, c);
  std::array<std::complex<double>, 3> sorted = {real, first, second};
  std::sort(sorted.begin(), sorted.end(), [](const auto& left, const auto& right) {
    return left.real() != right.real() ? left.real() < right.real() : left.imag() < right.imag();
  });
  return sorted;
}

void requireStable(const SlidingModeGains& gains) {
  const double worst = poles(gains)[2].real();
  if (worst < 0.0) return;
  throw InvalidConfig("the gains controller.k1, k2, k3 of " + numberText(gains.k1) + ", " +
                      numberText(gains.k2) + ", " + numberText(gains.k3) + " have a pole at " +
                      numberText(worst) + " 1/s; all must be negative");
}

}  // namespace lamina
