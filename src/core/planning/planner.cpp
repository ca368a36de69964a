// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/planner.hpp"

#include <utility>

#include "lamina/base/parallel.hpp"
#include "planning/layer_chain.hpp"
#include "planning/layer_planner.hpp"
#include "planning/travel.hpp"

namespace lamina {
namespace {

PlanContext contextFor(const std::vector<Layer>& layers, const PlanSettings& settings) {
  PlanContext context;
  context.settings = settings;
  context.strategy = infillStrategy(settings.infill.strategy);
  SettingsSchema schema;
  describe(schema, context.settings);
  schema.validate();
  for (const Layer& layer : layers) {
    const Box2 box = boundingBox(layer.section.contours);
    if (box.isEmpty()) continue;
    context.anchor = box.low;
    break;
  }
  return context;
}

/// Layers are planned apart from each other; only here does each learn where the nozzle comes from.
void joinLayers(std::vector<ToolpathLayer>& layers, const TravelSettings& settings) {
  const Path* previous = nullptr;
  for (ToolpathLayer& layer : layers) {
    if (layer.paths.empty()) continue;
    if (previous != nullptr) {
      std::optional<Path> travel =
          makeTravel(previous->lastPoint(), layer.paths.front().firstPoint(), settings);
      if (travel) layer.paths.insert(layer.paths.begin(), std::move(*travel));
    }
    previous = &layer.paths.back();
  }
}

}  // namespace

Toolpath planToolpath(const std::string& part_name, const std::vector<Layer>& layers,
                      const PlanSettings& settings, Progress& progress) {
  const PlanContext context = contextFor(layers, settings);
  Toolpath toolpath;
  toolpath.part_name = part_name;
  toolpath.layers.resize(layers.size());
  parallelFor(
      layers.size(), [&](std::size_t i) { toolpath.layers[i] = planLayer(layers[i], i, context); }, progress,
      "plan");
  if (context.strategy.link == LayerLink::Chained) chainLayers(toolpath.layers, settings, context.anchor);
  joinLayers(toolpath.layers, settings.travel);
  return toolpath;
}

}  // namespace lamina
