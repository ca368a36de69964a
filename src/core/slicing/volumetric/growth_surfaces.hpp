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

/// For each layer, given by the growth at which it begins and ends, whether it is level as a whole: the plane
/// at its height meets only level growth, and the growth of the layer occurs nowhere else.
/// @param bed_mm  z of the bed
std::vector<char> levelLayers(const CellGraph& cells, const GrowthLattice& lattice,
                              const std::vector<LayerBounds>& layers, double bed_mm);

/// Layers, given by the growth at which each begins and ends, and which of them get no surface.
struct LayersToCut {
  const std::vector<LayerBounds>& layers;
  const std::vector<char>& is_left;
};

/// Surfaces of equal growth midway through each layer, with one vertex for each cube that they cross, cut off
/// at the part's skin. Layer heights at the vertices follow from the gradient. The result does not depend on
/// the number of threads.
/// @throws Cancelled
std::vector<LayerSurface> growthSurfaces(const GrowthLattice& lattice, const CellGraph& cells,
                                         const LayersToCut& cut, const SignedDistance& skin,
                                         Progress& progress);

}  // namespace lamina
