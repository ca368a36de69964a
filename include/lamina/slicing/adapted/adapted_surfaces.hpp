// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/slicing/adapted/adapted_layers.hpp"

namespace lamina {

/// Layer surfaces bounded by adapted curves, for fills inside the walls; [Flores2018] has walls only. Seen
/// from above, a surface covers the area enclosed by the walls half way between the curves of its layer and
/// the curves below: layers of leaning walls then have the volume of the part. The height of a surface equals
/// the curves' height on the border, and satisfies Laplace's equation inside. The thickness is the distance
/// to the surface below, for the lowest layer to the level bottom of the part.
///
/// @param bottom_mm  z of the part's bottom [part frame]
/// @param step_mm    distance between points inside
/// @return one surface per layer. A layer that completes an uneven top ends on the layer below; it is cut off
///   where it is thinner than a quarter of its curves' height, and may be empty.
/// @throws InvalidInput naming the layer if a curve crosses itself seen from above; Cancelled
std::vector<LayerSurface> adaptedSurfaces(const AdaptedLayers& layers, double bottom_mm, double step_mm,
                                          Progress& progress);

}  // namespace lamina
