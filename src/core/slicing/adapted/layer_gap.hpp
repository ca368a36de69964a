// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/geometry/mesh/mesh.hpp"
#include "slicing/adapted/growth.hpp"

namespace lamina {

/// What a layer may leave of the one below it.
struct GapLimit {
  double height_mm = 0.0;  ///< that the layer should have
  double step_mm = 0.0;    ///< between points: smaller details are not seen
};

/// Refuses a curve that leaves places of the closed curve below it farther away than twice the height and a
/// step.
/// @param layer  its number, for the message
/// @param mesh   the part, whose faces around the gap are the region
/// @throws Unsliceable naming the gap and where it is
void requireNoGap(const AdaptedCurve& curve, const PlacedCurve& below, const GapLimit& limit,
                  std::size_t layer, const Mesh& mesh);

}  // namespace lamina
