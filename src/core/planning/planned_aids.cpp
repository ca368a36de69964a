// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/planned_aids.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/simplify.hpp"
#include "planning/skirt.hpp"
#include "planning/supports/overhang_areas.hpp"
#include "planning/supports/stacked_material.hpp"
#include "planning/supports/support_areas.hpp"
#include "planning/supports/support_lattice.hpp"

namespace lamina {
namespace {

AidRuns loopsOf(std::vector<Polygon> loops, PathRole role, const LayerBounds& bounds, double width_mm) {
  std::vector<FillPath> runs;
  runs.reserve(loops.size());
  for (Polygon& loop : loops) runs.push_back({std::move(loop), true, role, Deposit::Bead, {}});
  AidRuns aids;
  aids.runs = std::make_shared<const std::vector<FillPath>>(std::move(runs));
  aids.bead = {width_mm, bounds.height()};
  aids.top_mm = bounds.top_mm;
  aids.order = RunOrder::AsGiven;
  return aids;
}

/// Areas of supports in each layer, and their lines.
struct PlannedSupports {
  std::vector<LayerAids> layers;
  Regions on_bed;
  SupportTotals totals;
};

PlannedSupports planSupports(const std::vector<Layer>& layers, const PlanContext& context,
                             Progress& progress) {
  const PlanSettings& settings = context.settings;
  const double width = settings.bead.width_mm;
  const StackedMaterial stack = stackedMaterial(layers, settings.simplification_mm, context.bed, progress);
  const std::vector<Regions> overhangs = overhangAreas(stack, settings.supports, progress);
  SupportAreas areas = supportAreas(stack, overhangs, settings.supports, width, progress);
  PlannedSupports planned;
  planned.totals = areas.totals;
  planned.layers =
      supportLattice(areas.layers, settings, layers[layers.size() / 2].bounds.height(), progress);
  addVolumes(planned.totals, planned.layers);
  for (const SupportSection& section : areas.layers.front())
    for (const SharedRegions& regions : {section.lattice, section.interface})
      planned.on_bed.insert(planned.on_bed.end(), regions->begin(), regions->end());
  return planned;
}

}  // namespace

PlannedAids planAids(const std::vector<Layer>& layers, const PlanContext& context, Progress& progress) {
  const PlanSettings& settings = context.settings;
  PlannedAids planned;
  if (context.lift || context.strategy.deposit == Deposit::Drops || layers.empty()) return planned;
  const bool has_skirt = settings.skirt.count > 0 && !context.bed;
  if (!has_skirt && !settings.supports.use) return planned;
  planned.layers.resize(layers.size());
  PlannedSupports supports;
  if (settings.supports.use) {
    supports = planSupports(layers, context, progress);
    planned.supports = supports.totals;
    planned.layers = std::move(supports.layers);
  }
  if (has_skirt) {
    Regions around = unite(simplify(layers.front().section.contours, settings.simplification_mm));
    std::move(supports.on_bed.begin(), supports.on_bed.end(), std::back_inserter(around));
    LayerAids& first = planned.layers.front();
    first.insert(first.begin(), loopsOf(makeSkirt(around, settings), PathRole::Skirt, layers.front().bounds,
                                        settings.bead.width_mm));
  }
  return planned;
}

}  // namespace lamina
