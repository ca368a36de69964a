// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/spatial/signed_distance.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/slicing/planar/layer_stack.hpp"
#include "slicing/volumetric/growth_lattice.hpp"

namespace lamina {

/// Whether each layer, by the growth at which it begins and ends, is level as a whole: the plane at its
/// height meets nothing but level growth, and no growth of that layer is anywhere else.
/// @param bed_mm  z of the bed
std::vector<char> levelLayers(const CellGraph& cells, const GrowthLattice& lattice,
                              const std::vector<LayerBounds>& layers, double bed_mm);

/// Layers by the growth at which each begins and ends, and those of them that get no surface.
struct LayersToCut {
  const std::vector<LayerBounds>& layers;
  const std::vector<char>& is_left;
};

/// Surfaces of equal growth half way through each layer, by one vertex a cube that they cross, ended at the
/// part's skin. Heights are those that the gradient gives at each vertex. The same for any number of threads.
/// @throws Cancelled
std::vector<LayerSurface> growthSurfaces(const GrowthLattice& lattice, const CellGraph& cells,
                                         const LayersToCut& cut, const SignedDistance& skin,
                                         Progress& progress);

}  // namespace lamina
