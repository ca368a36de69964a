// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <utility>
#include <vector>

#include "job/laps.hpp"
#include "job/modes/inclined_layers.hpp"
#include "job/modes/part_planning.hpp"
#include "job/modifiers/modified_layers.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/job/layer_heights_job.hpp"
#include "lamina/job/voids/drop_void_job.hpp"
#include "lamina/kinematics/model/sensor_lean.hpp"
#include "lamina/planning/compensation/compensation.hpp"
#include "lamina/planning/scan_pass.hpp"
#include "lamina/slicing/planar/layer_plane.hpp"
#include "planning/tools/tool_beads.hpp"

namespace lamina {
namespace {

/// @param source        turned so that the layers are level
/// @param layer_bounds  where its layers lie
std::vector<Layer> sliceIntoLayers(const SourcePart& source, const std::vector<LayerBounds>& layer_bounds,
                                   const SlicingSettings& settings, Progress& progress) {
  if (layer_bounds.empty())
    throw InvalidInput(
        "the part is " + numberText(boundingBox(source.mesh).size().z()) +
        " mm high across its layers; the first layer of " + numberText(settings.first_layer_height_mm) +
        " mm needs more than half of that (input.unit states the unit of a file that states none)");
  std::vector<double> heights;
  heights.reserve(layer_bounds.size());
  for (const LayerBounds& bounds : layer_bounds) heights.push_back(bounds.cut());
  std::vector<Section> sections = sliceMesh(source.mesh, source.topology, heights, progress);
  std::vector<Layer> layers(layer_bounds.size());
  for (std::size_t i = 0; i < layers.size(); ++i) layers[i] = {layer_bounds[i], std::move(sections[i])};
  return layers;
}

/// Where the nozzle may be over the bed [part frame].
Box2 bedBelowPart(const PlanningRequest& request) {
  const Box3 tips = boundingBox(request.space);
  const Eigen::Isometry3d part_from_bed = request.bed_from_part.inverse();
  Box2 bed;
  for (const double x : {tips.low.x(), tips.high.x()})
    for (const double y : {tips.low.y(), tips.high.y()})
      bed.include((part_from_bed * Point3(x, y, tips.low.z())).head<2>());
  return bed;
}

Box2 commonBed(const Box2& bed, const std::optional<Box2>& other) {
  if (!other) return bed;
  return {bed.low.cwiseMax(other->low), bed.high.cwiseMin(other->high)};
}

/// Lines of a sparse infill lie over each other, and patterns fit, only if they are as far apart in every
/// layer: so far that the part gets the volume its density asks for.
PlanSettings withCommonSpacing(PlanSettings settings, const std::vector<Layer>& layers) {
  constexpr double kDense = 0.8;  // lines that nearly touch are fitted to their layer
  InfillSettings& infill = settings.infill;
  if (infill.pitch_mm > 0.0 || infill.density == 0.0 || infill.density >= kDense) return settings;
  double area_mm2 = 0.0;
  double height_mm = 0.0;
  for (const Layer& layer : layers) {
    area_mm2 += crossSection(beadOf(PathRole::Infill, settings, layer.bounds.height()).bead);
    height_mm += layer.bounds.height();
  }
  infill.pitch_mm = area_mm2 / (infill.density * height_mm);
  return settings;
}

/// In the frame of the layers.
Plan planOf(ModifiedLayers modified, const PlanningRequest& request, const Box2& bed, Progress& progress) {
  const JobSettings& job = request.job.settings;
  const std::vector<Layer>& layers = modified.layers;
  const auto completed = [&](PlanSettings settings) {
    settings.overhangs.least_feed_mm_s = job.cooling.least_feed_mm_s;
    return job.slicing.heights == LayerHeights::Equal ? settings
                                                      : withCommonSpacing(std::move(settings), layers);
  };
  PlanSettings settings = completed(job.planning);
  if (!settings.supports.use && asksForSupports(modified)) {
    settings.supports.use = true;
    modified.marks.unmarked = UnmarkedOverhangs::LeftOut;
  }
  for (PlanVariant& variant : modified.variants) variant.settings = completed(std::move(variant.settings));
  const PlaneSettings& plane = job.slicing.plane;
  if (plane.angle_deg == 0.0)
    return planPart(request.partName(), std::move(modified.layers), settings,
                    VariedBed{bed, modified.variants, &modified.marks, &modified.seams}, progress);
  const LayerIncline incline{bedBelow(plane, request.bed_from_part), partFromLayers(plane)};
  return planPart(request.partName(), layers, settings, incline, progress);
}

}  // namespace

PlannedPart planPlanar(SourcePart source, const PlanningRequest& request, Progress& progress) {
  const JobSettings& settings = request.job.settings;
  const PlaneSettings& plane = settings.slicing.plane;
  Laps laps;
  if (plane.angle_deg != 0.0) {
    source.mesh = turned(std::move(source.mesh), partFromLayers(plane).conjugate());
    source.volumes.clear();
  }
  LayerHeightsReport heights = layerHeightsOf(source.mesh, settings.slicing);
  requireCapableOf(heights, settings);
  std::vector<Layer> layers = sliceIntoLayers(source, heights.bounds, settings.slicing, progress);
  const FirstLayerSettings& first_layer = settings.planning.first_layer;
  compensate(layers, settings.compensation, first_layer,
             first_layer.width_factor * settings.planning.bead.width_mm, progress);
  ModifiedLayers modified = withModifiers(std::move(layers), source, settings, progress);
  PlannedPart planned;
  planned.notes = notesOn(heights, settings.slicing);
  planned.notes.insert(planned.notes.end(), modified.notes.begin(), modified.notes.end());
  planned.lean = overhangAngle(source.mesh, Point3::UnitZ(),
                               {settings.planning.bead.width_mm, settings.slicing.layer_height_mm});
  planned.lean.greatest_at = partFromLayers(plane) * planned.lean.greatest_at;
  const Box2 bed = commonBed(bedBelowPart(request), source.bed_around);
  source = {};
  planned.counts = countsOf(modified.layers);
  planned.counts.slice_s = laps.lap();
  planned.plan = planOf(std::move(modified), request, bed, progress);
  Toolpath& toolpath = planned.plan.toolpath;
  if (settings.drop_voids.is_on)
    toolpath = withDropVoidsFilled(std::move(toolpath), settings.drop_voids,
                                   settings.planning.travel.feed_mm_s, progress);
  const Eigen::Quaterniond inclined = partFromLayers(plane);
  toolpath = withScanPasses(std::move(toolpath), settings.scan,
                            {sensorOffset(request.space, inclined), sensorLean(request.space, inclined)});
  toolpath = inPartFrame(std::move(toolpath), plane);
  return planned;
}

}  // namespace lamina
