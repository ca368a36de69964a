// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/planar/layer_stack.hpp"

#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "slicing/positive_length.hpp"

namespace lamina {
namespace {

constexpr double kMostLayers = 1e7;

}  // namespace

std::vector<LayerBounds> stackLayers(double bottom_mm, double top_mm, const SlicingSettings& settings) {
  requirePositive("slicing.layer_height_mm", settings.layer_height_mm);
  requirePositive("slicing.first_layer_height_mm", settings.first_layer_height_mm);
  const double first_top = bottom_mm + settings.first_layer_height_mm;
  const double more = std::ceil((top_mm - first_top) / settings.layer_height_mm - 0.5);
  if (more > kMostLayers)
    throw InvalidConfig("slicing.layer_height_mm is " + numberText(settings.layer_height_mm) +
                        " mm; a part " + numberText(top_mm - bottom_mm) +
                        " mm high would have more than 10 million layers");
  std::vector<LayerBounds> layer_bounds;
  if (!(bottom_mm + 0.5 * settings.first_layer_height_mm < top_mm)) return layer_bounds;
  layer_bounds.push_back({bottom_mm, first_top});
  // Multiplied, not added up, so that the thousandth layer is as exact as the second.
  for (double i = 0.0; i < more; ++i)
    layer_bounds.push_back(
        {first_top + i * settings.layer_height_mm, first_top + (i + 1.0) * settings.layer_height_mm});
  while (!(layer_bounds.back().cut() < top_mm)) layer_bounds.pop_back();
  return layer_bounds;
}

}  // namespace lamina
