// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Joint positions at a time, on the cubic (Hermite) polynomial through two points with their velocities, as
/// controllers interpolate.
/// @tparam Point  type with the members time_s, position and velocity
/// @param b  must be later than `a`
template <class Point>
JointValues cubicPosition(const Point& a, const Point& b, double time_s) {
  const double h = b.time_s - a.time_s;
  const double u = (time_s - a.time_s) / h;
  const double v = 1.0 - u;
  return v * v * (1.0 + 2.0 * u) * a.position + u * u * (1.0 + 2.0 * v) * b.position +
         h * u * v * (v * a.velocity - u * b.velocity);
}

/// Joint velocities at a time, on the polynomial of `cubicPosition`.
template <class Point>
JointValues cubicVelocity(const Point& a, const Point& b, double time_s) {
  const double h = b.time_s - a.time_s;
  const double u = (time_s - a.time_s) / h;
  const double v = 1.0 - u;
  return 6.0 * u * v / h * (b.position - a.position) + v * (v - 2.0 * u) * a.velocity +
         u * (u - 2.0 * v) * b.velocity;
}

}  // namespace lamina
