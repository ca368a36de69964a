// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <utility>
#include <vector>

#include "job/laps.hpp"
#include "job/modes/layer_stack_planning.hpp"
#include "lamina/planning/walls/adapted_walls.hpp"
#include "lamina/slicing/adapted/adapted_layers.hpp"
#include "lamina/slicing/adapted/adapted_surfaces.hpp"

namespace lamina {
namespace {

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

/// Walls and infill on the surfaces that the curves span.
PlannedPart planFilled(const AdaptedLayers& layers, Mesh part, const PlanningRequest& request,
                       Progress& progress) {
  SurfaceStack stack;
  const double bottom_mm = boundingBox(part).low.z();
  stack.part = std::move(part);
  for (LayerSurface& surface :
       adaptedSurfaces(layers, bottom_mm, request.job.settings.adapted.step_mm, progress))
    if (!surface.middle.triangles.empty()) stack.layers.push_back({{}, std::move(surface)});
  return planStack(std::move(stack), request, progress);
}

std::string noteOnAdapted(const AdaptedLayers& layers) {
  return std::to_string(layers.layers.size()) + " layers adapted to the wall, " +
         std::to_string(layers.completing) + " of them complete its top by open curves";
}

}  // namespace

PlannedPart planAdapted(SourcePart source, const PlanningRequest& request, Progress& progress) {
  const JobSettings& settings = request.job.settings;
  Laps laps;
  const AdaptedLayers layers = adaptedLayers(source.mesh, settings.slicing, settings.adapted, progress);
  Mesh part = std::move(source.mesh);
  source = {};
  const double slice_s = laps.lap();
  PlannedPart planned = isLoneWall(settings.planning)
                            ? planWall(layers, request)
                            : planFilled(layers, std::move(part), request, progress);
  planned.counts.slice_s += slice_s;
  planned.notes.push_back(noteOnAdapted(layers));
  return planned;
}

}  // namespace lamina
