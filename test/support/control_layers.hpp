// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/layer_cells.hpp"

namespace lamina::test {

/// A layer of straight beads along x at these y, 3 x 1.5 mm, deposited at 10 mm/s, with a travel before each
/// but the first.
inline ToolpathLayer straightBeadLayer(const std::vector<double>& beads_y, double length_mm,
                                       double z_mm = 1.5) {
  ToolpathLayer layer{z_mm, 1.5, {}};
  for (const double y : beads_y) {
    Path bead;
    bead.role = PathRole::Infill;
    bead.bead = Bead{3.0, 1.5};
    bead.feed_mm_s = 10.0;
    bead.points = {{0, y, z_mm}, {length_mm, y, z_mm}};
    if (!layer.paths.empty()) {
      Path travel;
      travel.role = PathRole::Travel;
      travel.feed_mm_s = 50.0;
      travel.points = {layer.paths.back().lastPoint(), bead.points[0]};
      layer.paths.push_back(travel);
    }
    layer.paths.push_back(bead);
  }
  return layer;
}

/// Layers of two such beads of 40 mm, 1.5 mm apart, with a travel from each to the next, which is its path 0.
inline Toolpath stackedBeads(std::size_t layers) {
  Toolpath part{"beads", {}};
  for (std::size_t k = 1; k <= layers; ++k) {
    ToolpathLayer layer = straightBeadLayer({0.0, 3.0}, 40.0, 1.5 * static_cast<double>(k));
    if (k > 1) {
      Path up;
      up.role = PathRole::Travel;
      up.feed_mm_s = 50.0;
      up.points = {part.layers.back().paths.back().lastPoint(), layer.paths.front().firstPoint()};
      layer.paths.insert(layer.paths.begin(), up);
    }
    part.layers.push_back(layer);
  }
  return part;
}

inline LayerCells straightBeads(const std::vector<double>& beads_y, double length_mm, double cell_mm) {
  return layerCells(straightBeadLayer(beads_y, length_mm), 0, cell_mm);
}

}  // namespace lamina::test
