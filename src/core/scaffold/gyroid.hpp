// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A level section of the gyroid sin x cos y + sin y cos z + sin z cos x = 0.
struct GyroidSlice {
  double period_mm = 1.0;
  double z_mm = 0.0;
  double angle_rad = 0.0;  ///< rotation about z
};

/// The curves of the section inside a convex outline, ordered across it, alternating in direction.
/// @param outline  counter-clockwise
std::vector<Polyline> gyroidLines(const GyroidSlice& slice, const Polygon& outline);

}  // namespace lamina
