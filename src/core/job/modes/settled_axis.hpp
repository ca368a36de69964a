// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Keeps tool axes away from what is nearly upright, where a table or a head has to follow their azimuth the
/// faster the nearer they are: what leans less than an angle is put exactly upright, where that joint is free
/// to turn on the way, and what leans up to twice that is drawn in so that nothing jumps.
/// @param axis      opposite to the tool axis, of unit length [bed frame, z up]
/// @param half_rad  positive; no axis is turned by more
Point3 settledAxis(const Point3& axis, double half_rad);

/// The same of all waypoints of a toolpath; orientations of axes that stay are kept to the bit.
void settleAxes(Toolpath& toolpath, double half_rad);

}  // namespace lamina
