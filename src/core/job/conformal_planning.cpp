// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "job/laps.hpp"
#include "job/layer_stack_planning.hpp"
#include "lamina/slicing/conformal_layers.hpp"

namespace lamina {
namespace {

ConformalLayers conformalLayers(const SourcePart& source, const JobSettings& settings, Progress& progress) {
  const double height = settings.slicing.layer_height_mm;
  if (settings.conformal.base.empty())
    return coatingLayers(source.mesh, settings.conformal, height, progress);
  const SourcePart base = readPart(settings.conformal.base, settings.input);
  return layersOnBase(source.mesh, base.mesh, settings.conformal, height, progress);
}

std::string noteOn(const ConformalLayers& layers, const ConformalSettings& settings) {
  char text[200];
  if (settings.base.empty())
    std::snprintf(text, sizeof text, "a coat of %.4g mm in %zu layers of %.4g mm on the part",
                  settings.thickness_mm, layers.layers.size(), layers.layer_height_mm);
  else
    std::snprintf(text, sizeof text, "%zu layers of %.4g mm on the base; they leave %.2f %% of the part open",
                  layers.layers.size(), layers.layer_height_mm,
                  100.0 * (1.0 - layers.laid_mm3 / layers.part_mm3));
  return text;
}

}  // namespace

PlannedPart planConformal(SourcePart source, const PlanningRequest& request, Progress& progress) {
  const JobSettings& settings = request.job.settings;
  Laps laps;
  ConformalLayers layers = conformalLayers(source, settings, progress);
  source = {};
  const std::string note = noteOn(layers, settings.conformal);
  std::vector<StackedSurface> stack;
  stack.reserve(layers.layers.size());
  for (LayerSurface& surface : layers.layers) stack.push_back({{}, std::move(surface)});
  const double slice_s = laps.lap();
  PlannedPart planned = planStack(std::move(stack), request, progress);
  planned.counts.slice_s += slice_s;
  planned.notes.push_back(note);
  return planned;
}

}  // namespace lamina
