// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Angle between two directions [deg], accurate for small angles too.
double angleDeg(const Point3& a, const Point3& b);

/// Angle between a tool axis and straight down [deg].
double leanDeg(const Point3& tool_axis);

/// The tool axis turned towards straight down, in its own vertical plane, until its lean is at most
/// `max_deg`. A tool axis that points straight up has no such plane; it is turned in the plane of x and z.
/// @param tool_axis  of unit length
Point3 withLeanLimit(const Point3& tool_axis, double max_deg);

/// Tool axes near the wanted ones that turn from waypoint to waypoint by at most `max_deg_per_mm` times the
/// length of the motion. A sudden turn is spread evenly over the motions before and after it. The limit also
/// holds for the return to the start of a closed path. Tool axes that need no change are not changed. Every
/// result lies between wanted tool axes: it keeps any limit on lean, up to 90 degrees, that the wanted ones
/// keep.
///
/// @param wanted  of unit length, one or more
/// @param lengths  of the motions [mm]: as many as there are tool axes if the path is closed, else one fewer
std::vector<Point3> withTurnLimit(const std::vector<Point3>& wanted, const std::vector<double>& lengths,
                                  double max_deg_per_mm);

}  // namespace lamina
