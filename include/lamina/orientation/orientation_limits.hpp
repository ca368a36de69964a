// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Angle between two directions [deg], exact also for small ones.
double angleDeg(const Point3& a, const Point3& b);

/// Angle of a tool axis from straight down [deg].
double leanDeg(const Point3& tool_axis);

/// The tool axis raised towards straight down, in its own vertical plane, until its lean is at most
/// `max_deg`. A tool axis straight up has no such plane and leans towards x.
/// @param tool_axis  of unit length
Point3 withLeanLimit(const Point3& tool_axis, double max_deg);

/// Tool axes near the wanted ones that turn from waypoint to waypoint by at most `max_deg_per_mm` times the
/// length of the motion. A sudden turn is spread evenly over the motions before and after it. The limit holds
/// everywhere, on a closed path for the return to its start too. Tool axes that need no change are not
/// changed. All results lie between wanted ones, so that they keep a limit on lean of up to 90 degrees that
/// the wanted ones keep.
///
/// @param wanted  of unit length, one or more
/// @param lengths  of the motions [mm]: as many as there are tool axes if the path is closed, else one less
std::vector<Point3> withTurnLimit(const std::vector<Point3>& wanted, const std::vector<double>& lengths,
                                  double max_deg_per_mm);

}  // namespace lamina
