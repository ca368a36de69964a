// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/slicing/adapted/adapted_layers.hpp"

namespace lamina {

/// A place on one of several curves: on the segment from point `segment` to the next one.
struct CrossedPlace {
  std::size_t curve = 0;
  std::size_t segment = 0;
  double fraction = 0.0;
};

/// Two segments that cross each other, seen from above. The one with the lower index of curve, then of
/// segment, is first.
struct PlanCrossing {
  CrossedPlace first;
  CrossedPlace second;
};

/// All crossings of curves with themselves and each other, seen from above. Curves that only touch do not
/// cross. Takes time of order n log n if segments are about equally long.
/// @return in ascending order
std::vector<PlanCrossing> planCrossings(const std::vector<AdaptedCurve>& curves);

/// The point midway between the two places of a crossing, as a curve of one point, with all properties of a
/// curve's points, interpolated too.
AdaptedCurve pointAt(const std::vector<AdaptedCurve>& curves, const PlanCrossing& crossing);

}  // namespace lamina
