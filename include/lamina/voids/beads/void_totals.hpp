// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "lamina/voids/beads/void_map.hpp"

namespace lamina {

/// A part of the area of layers.
struct AreaShare {
  double area_mm2 = 0.0;       ///< of all layers together
  double mean_percent = 0.0;   ///< of the layers' own percentages, those without area left out
  double total_percent = 0.0;  ///< of the area of all layers together
  double worst_percent = 0.0;
  std::size_t worst_layer = 0;  ///< the first, if none has any
};

/// Sums over layers.
struct VoidTotals {
  std::size_t layers = 0;
  std::size_t voids = 0;
  std::map<VoidClass, std::size_t> voids_by_class;  ///< those there are
  AreaShare uncovered;
  AreaShare overfill;
  double material_percent = 0.0;  ///< deposited, of what fills the area of all layers
  double runs_per_layer_mean = 0.0;
};

VoidTotals totals(const std::vector<LayerVoids>& layers);

}  // namespace lamina
