// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/slicing/adapted/adapted_layers.hpp"

namespace lamina {

/// The curve without its small loops: where it crosses itself seen from above and the loop between is at most
/// `most_mm` long, the loop is replaced by one point at the crossing. Such loops arise at sharp edges of a
/// wall, as neighbouring points are drawn down the wall one by one and may come to lie in another order.
AdaptedCurve withoutSmallLoops(AdaptedCurve curve, double most_mm);

/// Refuses curves of a layer that cross themselves or each other, seen from above.
/// @param layer  its number, for the message
/// @param mesh   the part, whose faces around the crossing are the region
/// @throws Unsliceable naming the layer and the place
void requireNoCrossing(const std::vector<AdaptedCurve>& curves, std::size_t layer, const Mesh& mesh);

}  // namespace lamina
