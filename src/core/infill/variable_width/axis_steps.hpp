// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/medial_axis/medial_axis.hpp"

namespace lamina {

/// The point a part `t` of the way from one point of an axis to the other, its radius likewise.
AxisPoint between(const AxisPoint& from, const AxisPoint& to, double t);

/// The axis with more points, so that the radius changes by `step_mm` at most from one to the next.
/// @param points  one at least
std::vector<AxisPoint> inRadiusSteps(const std::vector<AxisPoint>& points, double step_mm);

}  // namespace lamina
