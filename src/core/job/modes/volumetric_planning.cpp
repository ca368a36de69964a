// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "job/laps.hpp"
#include "job/modes/fit/stack_fit.hpp"
#include "job/modes/head_stages.hpp"
#include "job/modes/layer_stack_planning.hpp"
#include "lamina/slicing/volumetric/volumetric_layers.hpp"

namespace lamina {
namespace {

std::string noteOnGrowth(const VolumetricMeasures& measures, double layer_height_mm) {
  char text[400];
  std::snprintf(
      text, sizeof text,
      "volumetric layers grown in %zu cells of %.3g mm with %.1f deg of overhang used, tilted by up to %.1f "
      "deg; thickness %.3f to %.3f mm, %.2f %% of the volume beyond its bounds; %zu layers are level",
      measures.nodes, measures.cell_mm, measures.overhang_used_deg, measures.tilt_deg,
      measures.thinnest * layer_height_mm, measures.thickest * layer_height_mm,
      100.0 * measures.beyond_thickness, measures.level_layers);
  return text;
}

std::string noteOnHanging(const VolumetricMeasures& measures, double max_overhang_deg) {
  char text[300];
  std::snprintf(
      text, sizeof text,
      "%.2f %% of the surface (%.4g mm²) overhangs its own layers by more than %.4g deg; level layers: %.2f "
      "%% (%.4g mm²)",
      100.0 * measures.unsupported_mm2 / measures.surface_mm2, measures.unsupported_mm2, max_overhang_deg,
      100.0 * measures.unsupported_level_mm2 / measures.surface_mm2, measures.unsupported_level_mm2);
  return text;
}

std::string noteOnFilling(const VolumetricMeasures& measures) {
  char text[400];
  std::snprintf(
      text, sizeof text,
      "%.2f %% of the part is in no layer (level layers: %.2f %%), %.2f %% in more than one; %.2f %% "
      "of the bent layers lie on what is deposited before, of the least of %zu pieces %.0f %%; %zu cells "
      "grow before their neighbours",
      100.0 * measures.open, 100.0 * measures.open_level, 100.0 * measures.twice, 100.0 * measures.resting,
      measures.pieces, 100.0 * measures.least_resting, measures.minima);
  return text;
}

std::string noteOnTarget(const VolumetricMeasures& measures) {
  char text[400];
  std::snprintf(text, sizeof text, "%.0f %% of the growth is fitted to volumetric.target%s%s",
                100.0 * measures.fitted,
                measures.fit_loss.empty() ? "" : "; with more: ", measures.fit_loss.c_str());
  return text;
}

void addNotesOnLeftOut(const VolumetricMeasures& measures, std::vector<std::string>& notes) {
  char text[200];
  if (measures.pendant_mm3 > 0.0) {
    std::snprintf(text, sizeof text,
                  "%.3g mm³ of the part, %.3f %%, hang where no growth leads: they are not deposited",
                  measures.pendant_mm3, 100.0 * measures.pendant_mm3 / measures.volume_mm3);
    notes.emplace_back(text);
  }
  if (measures.left_out_mm3 <= 0.0) return;
  std::snprintf(text, sizeof text,
                "pieces of volumetric layers smaller than a bead's square are left out: %.3f mm³ in all",
                measures.left_out_mm3);
  notes.emplace_back(text);
}

std::string noteOnHead(const VolumetricMeasures& measures, const TravelsOverPart& travels) {
  char text[300];
  std::snprintf(
      text, sizeof text,
      "the head leans by up to %.1f deg from the layers' normals to clear bed and part, and is not clear in "
      "%.2f %% of the volume; %zu of %zu travels are led round the part, for %zu no clear way was found",
      measures.greatest_lean_deg, 100.0 * measures.shut, travels.led_round, travels.travels, travels.shut);
  return text;
}

/// A head that cannot tilt has nothing to lean.
/// @param sunk_from_file  how the part that is sunk into the bed lies from its file
VolumetricRequest growthRequest(const PlanningRequest& request, const Eigen::Affine3d& sunk_from_file) {
  const JobSettings& settings = request.job.settings;
  VolumetricRequest growth{settings.volumetric, settings.slicing, settings.planning.bead.width_mm, {}, {}};
  if (settings.volumetric.target == GrowthTarget::Given)
    growth.directions = transformed(readDirectionSamples(settings.volumetric.target_file), sunk_from_file);
  if (canTurnToolAxis(request.space)) growth.head = headStages(settings.machine);
  return growth;
}

std::vector<StackedSurface> stackedLayers(VolumetricLayers layers) {
  std::vector<StackedSurface> stack;
  stack.reserve(layers.layers.size());
  for (VolumetricLayer& layer : layers.layers) {
    if (layer.isLevel())
      stack.push_back({std::move(layer.plane), {}});
    else
      stack.push_back({{}, std::move(layer.surface)});
  }
  return stack;
}

}  // namespace

PlannedPart planVolumetric(SourcePart source, const PlanningRequest& request, Progress& progress) {
  const JobSettings& settings = request.job.settings;
  Laps laps;
  const Eigen::Translation3d sinking(0.0, 0.0, -settings.volumetric.sink_mm);
  const VolumetricRequest growth = growthRequest(request, sinking * source.part_from_file);
  for (Point3& vertex : source.mesh.vertices) vertex = sinking * vertex;
  VolumetricLayers layers = volumetricLayers(source.mesh, source.topology, growth, progress);
  const double bed_mm = boundingBox(source.mesh).low.z() + settings.volumetric.sink_mm;
  SurfaceStack stack;
  stack.part = std::move(source.mesh);
  source = {};
  const VolumetricMeasures measures = layers.measures;
  const std::shared_ptr<const HeadRoom> room = layers.room;
  std::vector<double> tops_mm;
  for (const VolumetricLayer& layer : layers.layers) tops_mm.push_back(layer.plane.bounds.top_mm - bed_mm);
  Mesh hanging = std::move(layers.hanging);
  for (Point3& vertex : hanging.vertices) vertex.z() += settings.volumetric.sink_mm;
  const std::size_t bent_layers = layers.layers.size() - measures.level_layers;
  const double slice_s = laps.lap();
  stack.layers = stackedLayers(std::move(layers));
  PlannedPart planned = planStack(std::move(stack), request, progress);
  const double deposited_mm3 = totals(planned.plan.toolpath).deposited_mm3;
  MachineFit fit = fitGrown(std::move(planned.plan.toolpath), {*room, tops_mm}, request, progress);
  planned.plan.toolpath = std::move(fit.toolpath);
  planned.is_fitted = fit.still_hindered == 0;
  planned.counts.slice_s += slice_s;
  planned.support = SupportMeasures{
      measures.unsupported_mm2, bent_layers + (measures.level_layers > 0 ? std::size_t{1} : std::size_t{0}),
      std::move(hanging)};
  planned.notes = {noteOnGrowth(measures, settings.slicing.layer_height_mm),
                   noteOnHanging(measures, settings.volumetric.max_overhang_deg), noteOnFilling(measures)};
  if (settings.volumetric.target != GrowthTarget::Arrival) planned.notes.push_back(noteOnTarget(measures));
  planned.notes.push_back(noteOnHead(measures, fit.travels));
  if (fit.hindered > 0) planned.notes.push_back(noteOnFit(fit, deposited_mm3));
  addNotesOnLeftOut(measures, planned.notes);
  return planned;
}

}  // namespace lamina
