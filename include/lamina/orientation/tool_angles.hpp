// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A tool axis as two rotations of a tool that initially points along -z: about x by `alpha`, then about the
/// fixed y by `beta` [rad]. The tool axis is R_y(beta) R_x(alpha) (0, 0, -1) ([Guacheta2021, listing A.18],
/// with its third angle 0).
struct ToolAngles {
  double alpha = 0.0;  ///< -pi/2 to pi/2
  double beta = 0.0;   ///< -pi to pi
};

/// The two angles of a tool axis.
/// @param tool_axis  of unit length; if it lies along y, where every beta gives the same tool axis, beta is 0
ToolAngles toolAngles(const Point3& tool_axis);

/// The tool axis of two angles, of unit length.
Point3 toolAxisOf(const ToolAngles& angles);

}  // namespace lamina
