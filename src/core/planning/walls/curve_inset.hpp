// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/slicing/adapted/adapted_layers.hpp"

namespace lamina {

/// Which way a curve goes from the wall's surface into its material.
enum class InsetWay {
  AcrossWall,  ///< along the wall's normal
  Level        ///< keeping its height, farther where the wall leans, to the same distance from the wall
};

/// A curve of a wall, moved into the material along the wall's normal, which is across the curve and its
/// axes. Corners stay sharp: segments that end in one keep their distance. Where moved segments pass each
/// other, as at sharp edges, the curve is cut at their crossing seen from above, and pieces that lie nearer
/// to the wall than asked for are left out: there the material is thinner than twice the distance. So are
/// loops that enclose less than the square of the distance.
///
/// @param distance_mm  0 gives the curve itself
/// @return of a closed curve the loops that remain, more than one where a neck is too narrow, none where all
///         of it is; of an open one the same curve without loops
std::vector<AdaptedCurve> insetCurve(const AdaptedCurve& curve, double distance_mm, InsetWay way);

}  // namespace lamina
