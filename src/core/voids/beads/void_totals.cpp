// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/void_totals.hpp"

namespace lamina {
namespace {

double percent(double part, double whole) { return whole > 0.0 ? 100.0 * part / whole : 0.0; }

AreaShare shareOf(const std::vector<LayerVoids>& layers, double LayerVoids::*part) {
  AreaShare share;
  double sum_of_parts = 0.0;
  double whole = 0.0;
  double sum_of_percents = 0.0;
  std::size_t counted = 0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (!(layers[i].area_mm2 > 0.0)) continue;
    const double own = percent(layers[i].*part, layers[i].area_mm2);
    ++counted;
    sum_of_parts += layers[i].*part;
    whole += layers[i].area_mm2;
    sum_of_percents += own;
    if (own <= share.worst_percent) continue;
    share.worst_percent = own;
    share.worst_layer = i;
  }
  share.area_mm2 = sum_of_parts;
  share.total_percent = percent(sum_of_parts, whole);
  if (counted > 0) share.mean_percent = sum_of_percents / static_cast<double>(counted);
  return share;
}

}  // namespace

VoidTotals totals(const std::vector<LayerVoids>& layers) {
  VoidTotals totals;
  totals.layers = layers.size();
  totals.uncovered = shareOf(layers, &LayerVoids::uncovered_mm2);
  totals.overfill = shareOf(layers, &LayerVoids::overfill_mm2);
  totals.material_percent = shareOf(layers, &LayerVoids::deposited_mm2).total_percent;
  std::size_t runs = 0;
  for (const LayerVoids& layer : layers) {
    runs += layer.runs;
    totals.voids += layer.voids.size();
    for (const Void& each : layer.voids) ++totals.voids_by_class[each.kind];
  }
  if (!layers.empty())
    totals.runs_per_layer_mean = static_cast<double>(runs) / static_cast<double>(layers.size());
  return totals;
}

}  // namespace lamina
