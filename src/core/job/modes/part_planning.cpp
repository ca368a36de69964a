// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/part_planning.hpp"

namespace lamina {

LayerCounts countsOf(const std::vector<Layer>& layers) {
  LayerCounts counts;
  counts.layers = layers.size();
  for (const Layer& layer : layers) {
    counts.contours += layer.section.contours.size();
    counts.open_contours += layer.section.open_contours.size();
    counts.sliced_volume_mm3 += signedArea(layer.section.contours) * layer.bounds.height();
  }
  return counts;
}

}  // namespace lamina
