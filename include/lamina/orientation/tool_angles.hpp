// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A tool axis as two turns of a tool that points along -z at rest: about x by `alpha`, then about the fixed
/// y by `beta` [rad], the tool axis being R_y(beta) R_x(alpha) (0, 0, -1) ([Guacheta2021, listing A.18]; its
/// third angle is 0).
struct ToolAngles {
  double alpha = 0.0;  ///< -pi/2 to pi/2
  double beta = 0.0;   ///< -pi to pi
};

/// @param tool_axis  of unit length; along y, where every beta gives the same tool axis, beta is 0
ToolAngles toolAngles(const Point3& tool_axis);

/// The tool axis of two angles, of unit length.
Point3 toolAxisOf(const ToolAngles& angles);

}  // namespace lamina
