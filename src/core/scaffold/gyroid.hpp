// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A level cut through the gyroid sin x cos y + sin y cos z + sin z cos x = 0.
struct GyroidSlice {
  double period_mm = 1.0;
  double z_mm = 0.0;
  double angle_rad = 0.0;  ///< by which it is turned about z
};

/// The curves of the cut inside a convex outline, one after the other across it, to and fro.
/// @param outline  counter-clockwise
std::vector<Polyline> gyroidLines(const GyroidSlice& slice, const Polygon& outline);

}  // namespace lamina
