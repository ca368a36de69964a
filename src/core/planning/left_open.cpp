// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/left_open.hpp"

#include <algorithm>
#include <utility>
#include <vector>

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

namespace {

/// What of a layer is laid by settings, and which.
struct OpenArea {
  const PlanContext* context;
  Regions material;
};

bool isSolidInCells(const PlanContext& context) {
  return context.strategy.solid == SolidFit::InCells && isSolid(context.settings.infill);
}

/// Those areas of a layer that are to be solid by fills in cells.
std::vector<OpenArea> areasInCells(const StackedLayer& stacked, const PlanContext& context) {
  std::vector<const PlanContext*> all = {&context};
  for (const LayerVariant& variant : stacked.variants) all.push_back(variant.context);
  if (std::none_of(all.begin(), all.end(), [](const PlanContext* each) { return isSolidInCells(*each); }))
    return {};
  Regions rest = unite(simplify(stacked.layer->section.contours, context.settings.simplification_mm));
  std::vector<OpenArea> areas;
  for (const LayerVariant& variant : stacked.variants) {
    if (isSolidInCells(*variant.context))
      areas.push_back({variant.context, intersection(rest, *variant.area)});
    rest = difference(rest, *variant.area);
  }
  if (isSolidInCells(context)) areas.push_back({&context, std::move(rest)});
  return areas;
}

}  // namespace

LeftOpen leftOpenIn(const StackedLayer& stacked, const ToolpathLayer& planned, std::size_t index,
                    const PlanContext& context) {
  LeftOpen open;
  for (const OpenArea& each : areasInCells(stacked, context)) {
    const LayerVoids voids =
        findVoids(each.material, withoutFlow(planned, each.context->settings.bead.flow), {});
    open.area_mm2 += voids.area_mm2;
    open.open_mm2 += voids.uncovered_mm2;
  }
  if (open.area_mm2 <= 0.0) return {};
  open.worst_percent = 100.0 * open.open_mm2 / open.area_mm2;
  open.worst_layer = index;
  open.open_layers = open.worst_percent > kMostOpenPercent ? 1U : 0U;
  return open;
}

}  // namespace lamina
