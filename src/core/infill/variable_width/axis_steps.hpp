// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/medial_axis/medial_axis.hpp"

namespace lamina {

/// The point at share `t` of the distance between two points of an axis, with the radius interpolated too.
AxisPoint between(const AxisPoint& from, const AxisPoint& to, double t);

/// The axis with additional points, so that the radius changes by at most `step_mm` from one to the next.
/// @param points  not empty
std::vector<AxisPoint> inRadiusSteps(const std::vector<AxisPoint>& points, double step_mm);

}  // namespace lamina
