// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/left_open.hpp"

#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/simplify.hpp"
#include "lamina/voids/beads/void_map.hpp"
#include "planning/run_path.hpp"

namespace lamina {

LeftOpen& LeftOpen::operator+=(const LeftOpen& other) {
  area_mm2 += other.area_mm2;
  open_mm2 += other.open_mm2;
  open_layers += other.open_layers;
  if (other.worst_percent > worst_percent) {
    worst_percent = other.worst_percent;
    worst_layer = other.worst_layer;
  }
  return *this;
}

LeftOpen leftOpenIn(const StackedLayer& stacked, const ToolpathLayer& planned, std::size_t index,
                    const PlanContext& context) {
  const PlanSettings& settings = context.settings;
  if (context.strategy.solid != SolidFit::InCells || !isSolid(settings.infill) || !stacked.variants.empty())
    return {};
  const Regions material = unite(simplify(stacked.layer->section.contours, settings.simplification_mm));
  const LayerVoids voids = findVoids(material, withoutFlow(planned, settings.bead.flow), {});
  if (voids.area_mm2 <= 0.0) return {};
  const double percent = 100.0 * voids.uncovered_mm2 / voids.area_mm2;
  return {voids.area_mm2, voids.uncovered_mm2, percent, index, percent > kMostOpenPercent ? 1U : 0U};
}

}  // namespace lamina
