// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/run/cell_corrections.hpp"

#include <algorithm>
#include <utility>

#include "lamina/control/metal_split.hpp"

namespace lamina {

bool isAllZero(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return value == 0.0; });
}

RealisedCorrection realised(const LayerCells& cells, const LayerCorrection& asked,
                            const std::vector<double>& shift_mm, const LoopSettings& settings) {
  RealisedCorrection result{{}, asked};
  CellCorrections& told = result.told;
  if (!isAllZero(shift_mm)) told.dz_mm = shift_mm;
  if (isAllZero(asked.amount)) return result;
  told.amount = asked.amount;
  if (settings.speed_exponent == 0.0) return result;
  MetalCorrection split = metalSplit(cells, asked.amount, PowerSource::Fixed, settings);
  told.speed.reserve(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    told.speed.push_back(split.speed_mm_s[i] / cells.speed_mm_s[i] - 1.0);
    // What the wire brings per time is the same all over the layer.
    told.amount[i] = (1.0 + split.wire) / (1.0 + told.speed[i]) - 1.0;
  }
  result.laid.amount = std::move(split.amount);
  result.laid.limited_share = std::max(asked.limited_share, split.limited_share);
  return result;
}

void requireSpeeds(const Toolpath& toolpath, const LoopRunSettings& settings) {
  if (settings.loop.speed_exponent == 0.0) return;
  for (std::size_t layer = 0; layer < toolpath.layers.size(); ++layer) {
    const LayerCells cells = layerCells(toolpath.layers[layer], layer, settings.cell_mm);
    metalSplit(cells, std::vector<double>(cells.size(), 0.0), PowerSource::Fixed, settings.loop);
  }
}

}  // namespace lamina
