// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/pores/layer_pores.hpp"

#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/pores/pore_groups.hpp"
#include "lamina/pores/pore_projection.hpp"

namespace lamina {
namespace {

double partOf(std::int64_t part, std::int64_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

void addSlice(const VoxelGrid& solid, int k, LayerPores& layer) {
  NoProgress nobody;
  const PoreGroups openings = labelPores(openSlice(solid, k), nobody);
  std::int64_t open = 0;
  for (const PoreGroup& opening : openings.groups) {
    open += opening.voxels;
    if (isInner(opening)) layer.enclosed += opening.voxels;
  }
  layer.open += open;
  layer.solid += std::int64_t{solid.frame().count[0]} * solid.frame().count[1] - open;
}

}  // namespace

double LayerPores::voidRatio() const { return partOf(enclosed, enclosed + solid); }

double LayerPores::openRatio() const { return partOf(open, open + solid); }

std::vector<LayerPores> poresByLayer(const VoxelGrid& solid, const std::vector<LayerBand>& bands,
                                     Progress& progress) {
  const VoxelFrame& frame = solid.frame();
  std::vector<LayerPores> layers(bands.size());
  for (std::size_t l = 0; l < bands.size(); ++l) {
    const LayerBand& band = bands[l];
    if (!std::isfinite(band.low_mm) || !std::isfinite(band.high_mm) || band.low_mm > band.high_mm)
      throw InvalidInput("layer " + std::to_string(l) + " reaches from " + numberText(band.low_mm) + " to " +
                         numberText(band.high_mm) + " mm; must be finite and upwards");
    layers[l].band = band;
  }
  const auto count = [&](std::size_t l) {
    const Box3 box{Point3(frame.corner.x(), frame.corner.y(), bands[l].low_mm),
                   Point3(frame.corner.x(), frame.corner.y(), bands[l].high_mm)};
    const VoxelRange range = voxelsIn(frame, box);
    for (int k = range.low[2]; k < range.high[2]; ++k) addSlice(solid, k, layers[l]);
  };
  parallelFor(layers.size(), count, progress, "layers");
  return layers;
}

VoxelGrid openSlice(const VoxelGrid& solid, int k) {
  const auto& count = solid.frame().count;
  return inverted(cropped(solid, {{0, 0, k}, {count[0], count[1], k + 1}}));
}

}  // namespace lamina
