// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/layer_stack_planning.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "base/threads/joint_progress.hpp"
#include "job/laps.hpp"
#include "job/modes/stack_skins.hpp"
#include "lamina/base/layer_error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/parameterization/chart_outline.hpp"
#include "lamina/parameterization/layer_charts.hpp"
#include "lamina/parameterization/layer_volume.hpp"
#include "lamina/planning/lift/chart_lift.hpp"
#include "lamina/slicing/unsliceable.hpp"

namespace lamina {
namespace {

constexpr double kRounding = 1e-9;

/// What is planned of a layer, and how it comes back.
struct ChartedLayer {
  Layer plan;
  std::vector<LayerChart> charts;  // none if the layer is plane
  double volume_mm3 = 0.0;
  double left_out_mm3 = 0.0;                                     // in pieces that lie flat nowhere
  double highest_mm = -std::numeric_limits<double>::infinity();  // nozzle tip
};

double meanHeight(const LayerSurface& surface) {
  double sum = 0.0;
  for (const double height : surface.height_mm) sum += height;
  return sum / static_cast<double>(surface.height_mm.size());
}

std::vector<LayerChart> chartsOf(const LayerSurface& surface, const FlatteningSettings& settings,
                                 Progress& progress) {
  try {
    return layerCharts(surface, settings, progress);
  } catch (const InvalidMesh& fault) {
    throw Unsliceable(fault.what(), surface.middle);
  }
}

/// What flattening a layer takes, in triangles.
double sizeOf(const StackedSurface& layer) {
  return 1.0 + static_cast<double>(layer.surface.middle.triangles.size());
}

ChartedLayer charted(StackedSurface layer, const FlatteningSettings& settings, Progress& progress) {
  ChartedLayer result;
  if (layer.surface.middle.triangles.empty()) {
    result.plan = std::move(layer.plane);
    result.volume_mm3 = signedArea(result.plan.section.contours) * result.plan.bounds.height();
    result.highest_mm = result.plan.bounds.top_mm;
    return result;
  }
  for (const Point3& tip : layer.surface.tip) result.highest_mm = std::max(result.highest_mm, tip.z());
  result.volume_mm3 = volume(layer.surface);
  result.plan.bounds = {result.highest_mm - meanHeight(layer.surface), result.highest_mm};
  result.charts = chartsOf(layer.surface, settings, progress);
  result.left_out_mm3 = result.volume_mm3;
  for (const LayerChart& chart : result.charts) result.left_out_mm3 -= volume(chart.surface);
  for (const LayerChart& chart : result.charts)
    for (Polygon& outline : outlineOf(chart)) result.plan.section.contours.push_back(std::move(outline));
  return result;
}

/// Names the layer where it cannot be laid out flat.
ChartedLayer chartedAt(std::size_t index, StackedSurface layer, const FlatteningSettings& settings,
                       Progress& progress) {
  double highest_mm = layer.plane.bounds.top_mm;
  for (const Point3& tip : layer.surface.tip) highest_mm = std::max(highest_mm, tip.z());
  try {
    return charted(std::move(layer), settings, progress);
  } catch (const Cancelled&) {
    throw;
  } catch (...) {
    rethrowAt(layerPlace(index, highest_mm));
  }
}

/// A coat has a few layers, each of which may take seconds: they report and stop on their way.
std::vector<ChartedLayer> chartedLayers(std::vector<StackedSurface>& stack,
                                        const FlatteningSettings& settings, Progress& progress) {
  const std::string stage = "flatten";
  double triangles = 0.0;
  for (const StackedSurface& layer : stack) triangles += sizeOf(layer);
  JointProgress joint(progress, stage);
  std::vector<ChartedLayer> layers(stack.size());
  parallelFor(layers.size(), [&](std::size_t i) {
    throwIfCancelled(progress, stage);
    JointProgress::Part part(joint, sizeOf(stack[i]) / triangles);
    layers[i] = chartedAt(i, std::move(stack[i]), settings, part);
    part.report(stage, 1.0);
  });
  return layers;
}

LayerCounts countsOf(const std::vector<ChartedLayer>& layers) {
  LayerCounts counts;
  counts.layers = layers.size();
  for (const ChartedLayer& layer : layers) {
    counts.contours += layer.plan.section.contours.size();
    counts.open_contours += layer.plan.section.open_contours.size();
    counts.sliced_volume_mm3 += layer.volume_mm3;
  }
  return counts;
}

/// Up to and with each layer.
std::vector<double> highestUpTo(const std::vector<ChartedLayer>& layers, double standing_mm) {
  std::vector<double> highest;
  double so_far = standing_mm;
  for (const ChartedLayer& layer : layers) {
    so_far = std::max(so_far, layer.highest_mm);
    highest.push_back(so_far);
  }
  return highest;
}

}  // namespace

PlannedPart planStack(SurfaceStack stack, const PlanningRequest& request, Progress& progress) {
  const JobSettings& settings = request.job.settings;
  Laps laps;
  std::vector<ChartedLayer> layers = chartedLayers(stack.layers, settings.flattening, progress);
  PlannedPart planned;
  planned.counts = countsOf(layers);
  planned.counts.slice_s = laps.lap();
  const std::vector<double> highest = highestUpTo(layers, stack.standing_mm);
  std::vector<Layer> plans;
  std::vector<std::vector<LayerChart>> charts;
  for (ChartedLayer& layer : layers) {
    plans.push_back(std::move(layer.plan));
    charts.push_back(std::move(layer.charts));
  }
  const std::vector<bool> is_skin =
      skinsOfStack(plans.size(), settings.planning.skins, settings.slicing.layer_height_mm);
  const LayerLifting lifting{chartLift(charts, highest, settings.lifting, settings.planning.travel), is_skin,
                             stack.standing_mm,
                             coversOfStack({plans, charts, is_skin}, stack.part, settings, progress)};
  stack.part = Mesh();
  planned.plan = planPart(request.partName(), plans, settings.planning, lifting, progress);
  for (const ChartedLayer& layer : layers)
    if (layer.left_out_mm3 > kRounding * layer.volume_mm3) planned.plan.unprinted_mm3 += layer.left_out_mm3;
  return planned;
}

}  // namespace lamina
