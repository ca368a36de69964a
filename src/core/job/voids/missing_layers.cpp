// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/voids/missing_layers.hpp"

#include <cmath>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

/// Of a layer: what is less is no layer. A little more than half, as slicers leave out half a layer.
constexpr double kRest = 0.51;
constexpr double kMost = 1e6;

void addLayers(double from_mm, double to_mm, double height_mm, std::vector<ToolpathLayer>& layers) {
  if (!(height_mm > 0.0)) return;
  const double count = std::ceil((to_mm - from_mm) / height_mm - kRest);
  if (count > kMost)
    throw InvalidInput("the program lacks " + std::to_string(count) + " layers of " +
                       std::to_string(height_mm) + " mm of the part; expected a million at most");
  for (double k = 1.0; k <= count; ++k) {
    layers.emplace_back();
    layers.back().z_mm = from_mm + k * height_mm;
    layers.back().height_mm = height_mm;
  }
}

}  // namespace

std::vector<ToolpathLayer> layersBetween(const Toolpath& program, double part_height_mm) {
  std::vector<ToolpathLayer> missing;
  if (program.layers.empty()) return missing;
  for (std::size_t i = 1; i < program.layers.size(); ++i) {
    const ToolpathLayer& layer = program.layers[i];
    addLayers(program.layers[i - 1].z_mm, layer.z_mm - layer.height_mm, layer.height_mm, missing);
  }
  const ToolpathLayer& first = program.layers.front();
  const ToolpathLayer& last = program.layers.back();
  addLayers(last.z_mm, first.z_mm - first.height_mm + part_height_mm, last.height_mm, missing);
  return missing;
}

}  // namespace lamina
