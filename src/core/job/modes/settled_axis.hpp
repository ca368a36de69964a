// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Keeps tool axes away from nearly upright ones. Near upright, the joint of a table or head that follows the
/// azimuth of the axis would have to turn very fast. An axis that leans less than `half_rad` is made exactly
/// upright, where that joint may turn freely. One that leans up to twice as much is turned towards upright,
/// so that the result changes continuously with the axis.
/// @param axis      opposite to the tool axis, of unit length [bed frame, z up]
/// @param half_rad  positive; also the most by which an axis is turned
Point3 settledAxis(const Point3& axis, double half_rad);

/// Applies `settledAxis` to all waypoints of a toolpath. Orientations whose axis does not change keep their
/// exact values.
void settleAxes(Toolpath& toolpath, double half_rad);

}  // namespace lamina
