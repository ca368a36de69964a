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

/// Tool axes near the wanted ones whose turn from waypoint to waypoint is at most `max_deg_per_mm` times the
/// length of the motion between them. A sudden turn is spread evenly over what lies before and after it. On
/// an open path as on a closed one, whose return to its start counts, the limit holds everywhere. Tool axes
/// that need no change have none. All results lie between the wanted ones: a limit on lean of up to 90
/// degrees that these keep is kept.
///
/// @param wanted   of unit length, one or more
/// @param lengths  of the motions [mm]: as many as there are tool axes if the path is closed, else one less
std::vector<Point3> withTurnLimit(const std::vector<Point3>& wanted, const std::vector<double>& lengths,
                                  double max_deg_per_mm);

}  // namespace lamina
