// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "lamina/voids/beads/void_map.hpp"

namespace lamina {

/// A kind of area, such as the uncovered one, over all layers and as percentages of the layers' areas. Layers
/// without area are ignored.
struct AreaShare {
  double area_mm2 = 0.0;        ///< sum over all layers
  double mean_percent = 0.0;    ///< mean of the percentages of the layers
  double total_percent = 0.0;   ///< percentage of the area of all layers together
  double worst_percent = 0.0;   ///< greatest percentage of a layer
  std::size_t worst_layer = 0;  ///< index of the layer with the greatest percentage; 0 if there is none
};

/// Totals over all layers.
struct VoidTotals {
  std::size_t layers = 0;                           ///< number of layers
  std::size_t voids = 0;                            ///< number of voids
  std::map<VoidClass, std::size_t> voids_by_class;  ///< number of voids of each class that occurs
  AreaShare uncovered;
  AreaShare overfill;
  double material_percent = 0.0;     ///< deposited area, as a percentage of the area of all layers
  double runs_per_layer_mean = 0.0;  ///< mean number of paths that deposit
};
/// Sums up the voids of all layers.

VoidTotals totals(const std::vector<LayerVoids>& layers);

}  // namespace lamina
