// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/slicing/adapted/adapted_layers.hpp"

namespace lamina {

/// A place on one of several curves: on the way from point `segment` to the one after it.
struct CrossedPlace {
  std::size_t curve = 0;
  std::size_t segment = 0;
  double fraction = 0.0;
};

/// Two segments that pass through each other seen from above; the lower of curve, then segment, first.
struct PlanCrossing {
  CrossedPlace first;
  CrossedPlace second;
};

/// All crossings of curves with themselves and each other, seen from above. Touching is none. Time is
/// n log n where segments are of about the same length.
/// @return in ascending order
std::vector<PlanCrossing> planCrossings(const std::vector<AdaptedCurve>& curves);

/// The middle between the two places of a crossing, in all that a curve knows of a point: a curve of one
/// point.
AdaptedCurve pointAt(const std::vector<AdaptedCurve>& curves, const PlanCrossing& crossing);

}  // namespace lamina
