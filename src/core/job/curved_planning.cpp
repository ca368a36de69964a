// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "job/laps.hpp"
#include "job/layer_stack_planning.hpp"
#include "lamina/slicing/curved_layers.hpp"
#include "lamina/surface/layer_volume.hpp"
#include "lamina/surface/surface_cut.hpp"

namespace lamina {
namespace {

std::string noteOn(const CurvedLayers& layers) {
  char text[240];
  std::snprintf(text, sizeof text,
                "curved layers by the scheme '%s': %zu lower, %zu level, %zu upper; they leave %.2f %% of "
                "the part open",
                toString(layers.scheme), layers.lower.size(), layers.middle.size(), layers.upper.size(),
                100.0 * layers.volumes.gap());
  return text;
}

/// The first shell begins at the lowest place; what of it lies higher has nothing beneath it.
std::string noteOnFirstShell(const CurvedLayers& layers, double layer_height_mm) {
  if (layers.lower.empty()) return "";
  const LayerSurface& first = layers.lower.front();
  const Box3 box = boundingBox(first.middle);
  std::vector<double> above;
  for (const Point3& vertex : first.middle.vertices)
    above.push_back(vertex.z() - box.low.z() - layer_height_mm);
  const double hanging_mm3 = volume(whereNotNegative(first, above));
  if (hanging_mm3 <= 0.0) return "";
  char text[240];
  std::snprintf(
      text, sizeof text,
      "the first layer rises to %.4g mm above its lowest place: %.4g mm3 of it are laid on air, unless a "
      "bed of its shape or support lies there",
      box.size().z(), hanging_mm3);
  return text;
}

std::vector<StackedSurface> stacked(CurvedLayers layers) {
  std::vector<StackedSurface> stack;
  stack.reserve(layers.lower.size() + layers.middle.size() + layers.upper.size());
  for (LayerSurface& surface : layers.lower) stack.push_back({{}, std::move(surface)});
  for (Layer& plane : layers.middle) stack.push_back({std::move(plane), {}});
  for (LayerSurface& surface : layers.upper) stack.push_back({{}, std::move(surface)});
  return stack;
}

}  // namespace

PlannedPart planCurved(SourcePart source, const PlanningRequest& request, Progress& progress) {
  const JobSettings& settings = request.job.settings;
  Laps laps;
  CurvedLayers layers =
      curvedLayers(source.mesh, source.topology, settings.curved, settings.slicing.layer_height_mm, progress);
  source = {};
  const std::string note = noteOn(layers);
  const std::string air = noteOnFirstShell(layers, settings.slicing.layer_height_mm);
  const double slice_s = laps.lap();
  PlannedPart planned = planStack(stacked(std::move(layers)), request, progress);
  planned.counts.slice_s += slice_s;
  planned.notes.push_back(note);
  if (!air.empty()) planned.notes.push_back(air);
  return planned;
}

}  // namespace lamina
