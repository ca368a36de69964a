// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "trajectory/joint_curve.hpp"

namespace lamina {

/// A piece of a span along which speeds are planned: the straight part of it, or a part of the rounding of
/// one of its ends.
struct CurveCell {
  double start = 0.0;  ///< along the span
  double end = 0.0;
  std::uint32_t span = 0;
  std::int8_t part = 0;  ///< 0 straight; else of the rounding at the start (negative) or end (positive)
};

/// All cells of a curve in order, of positive length each.
std::vector<CurveCell> curveCells(const JointCurve& curve);

/// What joints and path allow in a cell. The squared speed x is linear along a cell, its rate of change
/// twice the acceleration s'' along the curve.
struct CellLimits {
  JointValues tangent;             ///< greatest first derivative of each joint
  JointValues bend;                ///< greatest second derivative
  JointValues acceleration;        ///< of the joints [mm/s², rad/s²]
  double path_acceleration = 0.0;  ///< along the curve
  double speed2 = 0.0;             ///< greatest x

  /// Greatest x at one end of a stretch of a cell, from that at the other: tangent |s''| + bend x must not
  /// exceed the acceleration of any joint at the faster end.
  double reachable(double x, double length) const;
  /// Greatest |s''| with which to brake from x.
  double braking(double x) const;
};

/// @param averaging_s  over which the motion will be averaged to limit jerk; 0 for not at all
CellLimits cellLimits(const JointCurve& curve, const CurveCell& cell, double averaging_s);

}  // namespace lamina
