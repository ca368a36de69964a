// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// What limits growth. Angles in radians.
struct GrowthLimits {
  double overhang_rad = 0.5;   ///< overhang that growth uses on purpose, below pi/2
  double max_thickness = 2.0;  ///< greatest thickness of a layer, relative to its nominal height; at least 1
  double max_tilt_rad = 1.4;   ///< greatest angle of the growth direction from the vertical
};

/// Cost of growing along a straight segment: the nominal layer height that is deposited. For a segment that
/// leans from the vertical by at most the overhang, the cost is its rise, so that layers are level there. For
/// a segment that leans more it is |way| cos(overhang) exp(-(lean - overhang) tan(overhang)): the normal of
/// the layer lags behind the segment by exactly the overhang, and the relative thickness of the layer is
/// exp((lean - overhang) tan(overhang)). Beyond the lean at which this reaches the greatest thickness, the
/// normal no longer changes and the cost is linear in the segment. For segments that do not lead down the
/// cost is convex, and smooth except at 0.
class GrowthGauge {
 public:
  explicit GrowthGauge(const GrowthLimits& limits);

  /// Cost of a segment [mm]; infinite if it leans more than `greatestLean`.
  double cost(const Point3& way) const;
  /// Gradient of the cost: the layer's normal times 1 over its relative thickness; straight up for a segment
  /// of length 0.
  Point3 gradient(const Point3& way) const;

  /// Greatest lean of a segment with a finite cost [rad].
  double greatestLean() const { return greatest_lean_; }

 private:
  double overhang_;
  double tan_overhang_;
  double cos_overhang_;
  double greatest_lean_;
  double thickest_lean_;  // lean from which on the thickness is the greatest one
  double thickest_tilt_;
  Point2 beyond_;  // gradient beyond that lean: horizontal and vertical component
};

/// The overhang, at most the one given, for which layers at a level underside are no thicker than
/// `max_thickness`.
/// @param max_thickness  relative to the nominal layer height; at least 1
/// @return [rad]
double overhangWithin(double overhang_rad, double max_thickness);

}  // namespace lamina
