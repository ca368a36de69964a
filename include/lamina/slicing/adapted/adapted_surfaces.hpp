// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/slicing/adapted/adapted_layers.hpp"

namespace lamina {

/// The surfaces that adapted curves span, so that what is inside the walls can be filled: for each layer the
/// area its curves enclose seen from above, at heights that satisfy Laplace's equation between the curves'
/// own. [Flores2018] knows walls only. The border's tips lie on the curves; its points are those of the
/// curves and those that had to be put between. Thickness is the distance to the surface below, of the
/// lowest layer that to the level bottom of the part.
///
/// @param bottom_mm  height of the part's bottom
/// @param step_mm    distance of the points inside
/// @return one per layer. Layers that complete an uneven top run out on the layer below; of these only what
///         is at least a quarter as thick as their curves are high, which may be nothing.
/// @throws InvalidInput naming the layer if a curve crosses itself seen from above; Cancelled
std::vector<LayerSurface> adaptedSurfaces(const AdaptedLayers& layers, double bottom_mm, double step_mm,
                                          Progress& progress);

}  // namespace lamina
