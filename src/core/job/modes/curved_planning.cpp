// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "job/laps.hpp"
#include "job/modes/layer_stack_planning.hpp"
#include "lamina/parameterization/layer_volume.hpp"
#include "lamina/parameterization/surface_cut.hpp"
#include "lamina/slicing/curved/curved_layers.hpp"
#include "slicing/curved/shell_tidying.hpp"

namespace lamina {
namespace {

std::string noteOnCurved(const CurvedLayers& layers) {
  char text[240];
  std::snprintf(
      text, sizeof text,
      "curved layers by the scheme '%s': %zu lower, %zu level, %zu upper; %.2f %% of the part is in "
      "none of them, %.2f %% in more than one",
      toString(layers.scheme), layers.lower.size(), layers.middle.size(), layers.upper.size(),
      100.0 * layers.coverage.open, 100.0 * layers.coverage.twice);
  return text;
}

/// Leaves out pieces of shells that are smaller than a bead's square: no bead has room there.
/// @return what they would have held [mm³]
double leaveOutSlivers(std::vector<LayerSurface>& shells, double bead_mm) {
  const double before = volume(shells);
  for (LayerSurface& shell : shells) shell = tidied(shell, {bead_mm * bead_mm, 0.0});
  const auto isEmpty = [](const LayerSurface& shell) { return shell.middle.triangles.empty(); };
  shells.erase(std::remove_if(shells.begin(), shells.end(), isEmpty), shells.end());
  return before - volume(shells);
}

std::string noteOnSlivers(double left_out_mm3) {
  char text[160];
  std::snprintf(text, sizeof text,
                "pieces of curved layers smaller than a bead's square are left out: %.3f mm³ in all",
                left_out_mm3);
  return text;
}

/// The first shell begins at the lowest place; what of it lies higher has nothing below it.
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
  std::snprintf(text, sizeof text,
                "the first layer rises to %.4g mm above its lowest place: %.4g mm3 of it are deposited on "
                "air, unless a bed of its shape or support lies there",
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
  Mesh part = std::move(source.mesh);
  source = {};
  const std::string note = noteOnCurved(layers);
  const std::string air = noteOnFirstShell(layers, settings.slicing.layer_height_mm);
  const double bead_mm = settings.planning.bead.width_mm;
  const double left_out = leaveOutSlivers(layers.lower, bead_mm) + leaveOutSlivers(layers.upper, bead_mm);
  const double slice_s = laps.lap();
  SurfaceStack stack;
  stack.layers = stacked(std::move(layers));
  stack.part = std::move(part);
  PlannedPart planned = planStack(std::move(stack), request, progress);
  planned.counts.slice_s += slice_s;
  planned.notes.push_back(note);
  if (!air.empty()) planned.notes.push_back(air);
  if (left_out > 0.0) planned.notes.push_back(noteOnSlivers(left_out));
  return planned;
}

}  // namespace lamina
