// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/slicing/adapted/adapted_layers.hpp"

namespace lamina {

/// The curve without loops that it makes seen from above and that are no longer than so much; a point where
/// it crosses itself takes the place of each. At sharp edges of a wall neighbouring points, each drawn down
/// the wall by itself, may come to lie in another order than their own.
AdaptedCurve withoutSmallLoops(AdaptedCurve curve, double most_mm);

/// Refuses curves of a layer that cross themselves or each other seen from above.
/// @param layer  its number, for the message
/// @param mesh   the part, whose faces around the crossing are the region
/// @throws Unsliceable naming the layer and the place
void requireNoCrossing(const std::vector<AdaptedCurve>& curves, std::size_t layer, const Mesh& mesh);

}  // namespace lamina
