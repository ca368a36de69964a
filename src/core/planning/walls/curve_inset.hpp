// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/slicing/adapted/adapted_layers.hpp"

namespace lamina {

/// Direction in which a curve is moved from the wall's surface into its material.
enum class InsetWay {
  AcrossWall,  ///< along the normal of the wall
  Level        ///< horizontally; the shift grows with the lean, to a constant distance along the normal
};

/// Moves a curve of a wall into the material. The wall's normal is perpendicular to the curve and to the
/// curve's axes. Corners stay sharp: segments that end in one keep their distance from the wall. Where moved
/// segments cross, as at sharp edges, the curve is cut at the crossing seen from above. Pieces closer to the
/// wall than the distance are left out, as the material is thinner than twice the distance there; so are
/// loops that enclose less than the square of the distance.
///
/// @param distance_mm  0 gives the curve itself
/// @return of a closed curve the remaining loops: several if a neck is too narrow, none if the whole curve is
///   too narrow; of an open curve the curve without loops
std::vector<AdaptedCurve> insetCurve(const AdaptedCurve& curve, double distance_mm, InsetWay way);

}  // namespace lamina
