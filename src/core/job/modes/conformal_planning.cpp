// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "job/laps.hpp"
#include "job/modes/layer_stack_planning.hpp"
#include "lamina/slicing/conformal/conformal_layers.hpp"

namespace lamina {
namespace {

ConformalLayers conformalLayers(const SourcePart& source, const JobSettings& settings, Progress& progress) {
  const double height = settings.slicing.layer_height_mm;
  if (source.base.triangles.empty()) return coatingLayers(source.mesh, settings.conformal, height, progress);
  return layersOnBase(source.mesh, source.base, settings.conformal, height, progress);
}

std::string noteOnConformal(const ConformalLayers& layers, const ConformalSettings& settings) {
  char text[200];
  if (settings.base.empty())
    std::snprintf(text, sizeof text, "a coat of %.4g mm in %zu layers of %.4g mm on the part",
                  settings.thickness_mm, layers.layers.size(), layers.layer_height_mm);
  else
    std::snprintf(text, sizeof text, "%zu layers of %.4g mm on the base; they leave %.2f %% of the part open",
                  layers.layers.size(), layers.layer_height_mm,
                  100.0 * (1.0 - layers.deposited_mm3 / layers.part_mm3));
  return text;
}

std::string noteOnHidden(double hidden_mm2) {
  char text[160];
  std::snprintf(text, sizeof text,
                "%.4g mm2 of faces that look in conformal.direction lie below others and get no coat",
                hidden_mm2);
  return text;
}

/// Something stands on the bed before the first layer: the nozzle comes from above it.
void comeFromAbove(Toolpath& toolpath, double highest_mm, const TravelSettings& travel) {
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      for (const Point3& point : path.points) highest_mm = std::max(highest_mm, point.z());
  for (ToolpathLayer& layer : toolpath.layers) {
    if (layer.paths.empty()) continue;
    const Point3 first = layer.paths.front().firstPoint();
    Path approach;
    approach.role = PathRole::Travel;
    approach.points = {{first.x(), first.y(), highest_mm + travel.hop_mm}, first};
    approach.orientation = layer.paths.front().orientation.at(0);
    approach.feed_mm_s = travel.feed_mm_s;
    layer.paths.insert(layer.paths.begin(), std::move(approach));
    return;
  }
}

}  // namespace

PlannedPart planConformal(SourcePart source, const PlanningRequest& request, Progress& progress) {
  const JobSettings& settings = request.job.settings;
  Laps laps;
  ConformalLayers layers = conformalLayers(source, settings, progress);
  const double highest_mm = std::max(boundingBox(source.mesh).high.z(), boundingBox(source.base).high.z());
  SurfaceStack stack;
  if (!source.base.triangles.empty()) stack.part = std::move(source.mesh);
  source = {};
  const std::string note = noteOnConformal(layers, settings.conformal);
  const double hidden_mm2 = layers.hidden_mm2;
  stack.standing_mm = highest_mm;
  stack.layers.reserve(layers.layers.size());
  for (LayerSurface& surface : layers.layers) stack.layers.push_back({{}, std::move(surface)});
  const double slice_s = laps.lap();
  PlannedPart planned = planStack(std::move(stack), request, progress);
  planned.standing_mm = highest_mm;
  planned.counts.slice_s += slice_s;
  planned.notes.push_back(note);
  if (hidden_mm2 > 0.0) planned.notes.push_back(noteOnHidden(hidden_mm2));
  comeFromAbove(planned.plan.toolpath, highest_mm, settings.planning.travel);
  return planned;
}

}  // namespace lamina
