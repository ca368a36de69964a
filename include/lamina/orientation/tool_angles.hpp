// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A jet as two turns of a tool that points along -z at rest: about x by `alpha`, then about the fixed y by
/// `beta` [rad], the jet being R_y(beta) R_x(alpha) (0, 0, -1) ([Guacheta2021, listing A.18]; its
/// third angle is 0).
struct ToolAngles {
  double alpha = 0.0;  ///< -pi/2 to pi/2
  double beta = 0.0;   ///< -pi to pi
};

/// @param jet  of unit length; along y, where every beta gives the same jet, beta is 0
ToolAngles toolAngles(const Point3& jet);

/// The jet of two angles, of unit length.
Point3 jetOf(const ToolAngles& angles);

}  // namespace lamina
