// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/lift/height_field_lift.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace lamina {

LayerLift heightFieldLift(const HeightFieldSlices& slices, const LiftSettings& settings,
                          const TravelSettings& travel) {
  const std::vector<double>& factors = slices.field.factor;
  const double thickest = factors.empty() ? 1.0 : *std::max_element(factors.begin(), factors.end());
  return [&slices, settings, travel, thickest](std::size_t index, ToolpathLayer planned) {
    const Layer& layer = slices.layers.at(index);
    std::vector<LayerChart> charts;
    charts.push_back(bentLayer(slices.field, layer.bounds, boundingBox(layer.section.contours)));
    const double base = slices.field.base_mm;
    // No place of a layer is higher than this, nor than the part by more than a layer.
    const double highest = std::min(base + (layer.bounds.top_mm - base) * thickest,
                                    slices.top_mm + layer.bounds.height() * thickest);
    return liftOnto(charts, std::move(planned), settings, travel, highest);
  };
}

}  // namespace lamina
