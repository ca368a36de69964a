// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// What limits growth. Angles in radians.
struct GrowthLimits {
  double overhang_rad = 0.5;   ///< that growth uses up on purpose, below pi/2
  double max_thickness = 2.0;  ///< of a layer, over its nominal height; at least 1
  double max_tilt_rad = 1.4;   ///< of the growth direction from up
};

/// What it takes to grow along a straight way: nominal layer height deposited, per length. A way up to the
/// overhang from upright takes its rise, so that layers are level there. One that leans more takes |way|
/// cos(overhang) exp(-(lean - overhang) tan(overhang)): the layer's normal lags behind the way by exactly the
/// overhang, and the layer's thickness is exp((lean - overhang) tan(overhang)). Where that reaches the
/// greatest thickness the layer's normal stays as it is, and the cost is linear in the way. Convex, and
/// smooth but at 0, for ways that do not lead down.
class GrowthGauge {
 public:
  explicit GrowthGauge(const GrowthLimits& limits);

  /// Growth along a way [mm]; infinite for one that leans more than `greatestLean`.
  double cost(const Point3& way) const;
  /// Gradient of the cost: the layer's normal by the inverse of its relative thickness; up for a zero way.
  Point3 gradient(const Point3& way) const;

  /// [rad]
  double greatestLean() const { return greatest_lean_; }

 private:
  double overhang_;
  double tan_overhang_;
  double cos_overhang_;
  double greatest_lean_;
  double thickest_lean_;  // from which the thickness stays
  double thickest_tilt_;
  Point2 beyond_;  // gradient there: across and up
};

/// The overhang at which a level underside gets layers no thicker than `max_thickness`; the one given if it
/// does.
double overhangWithin(double overhang_rad, double max_thickness);

}  // namespace lamina
