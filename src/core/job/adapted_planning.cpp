// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "job/laps.hpp"
#include "job/layer_stack_planning.hpp"
#include "lamina/planning/adapted_walls.hpp"
#include "lamina/slicing/adapted_layers.hpp"
#include "lamina/slicing/adapted_surfaces.hpp"
#include "planning/travel.hpp"

namespace lamina {
namespace {

/// The wall alone, as the source knows it.
bool isWallAlone(const PlanSettings& settings) {
  return settings.walls.count == 1 && settings.infill.density == 0.0;
}

PlannedPart planWall(const AdaptedLayers& layers, const PlanningRequest& request) {
  PlannedPart planned;
  planned.plan.toolpath.part_name = request.partName();
  planned.plan.toolpath.layers = adaptedWalls(layers, request.job.settings.planning);
  planned.counts.layers = layers.layers.size();
  for (const AdaptedLayer& layer : layers.layers)
    for (const AdaptedCurve& curve : layer.curves)
      ++(curve.is_closed ? planned.counts.contours : planned.counts.open_contours);
  return planned;
}

/// The layers at the end that complete an uneven top, of open curves that enclose nothing to fill.
AdaptedLayers completionOf(const AdaptedLayers& layers) {
  AdaptedLayers completion;
  completion.layers.assign(layers.layers.end() - static_cast<std::ptrdiff_t>(layers.completing),
                           layers.layers.end());
  completion.completing = layers.completing;
  return completion;
}

/// Adds layers behind those there are, joined by a travel.
void append(Toolpath& toolpath, std::vector<ToolpathLayer> layers, const TravelSettings& travel) {
  const auto last = std::find_if(toolpath.layers.rbegin(), toolpath.layers.rend(),
                                 [](const ToolpathLayer& layer) { return !layer.paths.empty(); });
  const auto first = std::find_if(layers.begin(), layers.end(),
                                  [](const ToolpathLayer& layer) { return !layer.paths.empty(); });
  if (last != toolpath.layers.rend() && first != layers.end()) {
    std::optional<Path> way =
        makeTravel(last->paths.back().lastPoint(), first->paths.front().firstPoint(), travel);
    if (way) first->paths.insert(first->paths.begin(), std::move(*way));
  }
  std::move(layers.begin(), layers.end(), std::back_inserter(toolpath.layers));
}

/// Walls and infill on the surfaces that the curves span.
PlannedPart planFilled(const AdaptedLayers& layers, double bottom_mm, const PlanningRequest& request,
                       Progress& progress) {
  const JobSettings& settings = request.job.settings;
  std::vector<StackedSurface> stack;
  for (LayerSurface& surface : adaptedSurfaces(layers, bottom_mm, settings.adapted.step_mm, progress))
    stack.push_back({{}, std::move(surface)});
  PlannedPart planned = planStack(std::move(stack), request, progress);
  append(planned.plan.toolpath, adaptedWalls(completionOf(layers), settings.planning),
         settings.planning.travel);
  planned.counts.layers += layers.completing;
  return planned;
}

std::string noteOn(const AdaptedLayers& layers) {
  return std::to_string(layers.layers.size()) + " layers adapted to the wall, " +
         std::to_string(layers.completing) + " of them complete its top by open curves";
}

}  // namespace

PlannedPart planAdapted(SourcePart source, const PlanningRequest& request, Progress& progress) {
  const JobSettings& settings = request.job.settings;
  Laps laps;
  const double bottom = boundingBox(source.mesh).low.z();
  const AdaptedLayers layers = adaptedLayers(source.mesh, settings.slicing, settings.adapted, progress);
  source = {};
  const double slice_s = laps.lap();
  PlannedPart planned = isWallAlone(settings.planning) ? planWall(layers, request)
                                                       : planFilled(layers, bottom, request, progress);
  planned.counts.slice_s += slice_s;
  planned.notes.push_back(noteOn(layers));
  return planned;
}

}  // namespace lamina
