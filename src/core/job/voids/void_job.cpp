// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/voids/void_job.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "job/modes/wall_contours.hpp"
#include "job/part/part_reading.hpp"
#include "job/part/shrinkage.hpp"
#include "job/voids/part_placing.hpp"
#include "job/voids/same_part.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/slicing/planar/planar_slicer.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/order/near_origin.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

/// Of a layer: what is less is no layer. A little more than half, as slicers leave out half a layer.
constexpr double kRest = 0.51;
constexpr double kMost = 1e6;

void addLayers(double from_mm, double to_mm, double height_mm, std::vector<ToolpathLayer>& layers) {
  if (!(height_mm > 0.0)) return;
  const double count = std::ceil((to_mm - from_mm) / height_mm - kRest);
  if (count > kMost)
    throw InvalidInput("the program lacks " + numberText(count) + " layers of " + numberText(height_mm) +
                       " mm of the part; expected a million at most");
  for (double k = 1.0; k <= count; ++k) {
    layers.emplace_back();
    layers.back().z_mm = from_mm + k * height_mm;
    layers.back().height_mm = height_mm;
  }
}

/// The first layer that holds a path of the part: what lies below it is a raft.
std::size_t firstOfPart(const Toolpath& program) {
  const auto holdsPart = [](const ToolpathLayer& layer) {
    return std::any_of(layer.paths.begin(), layer.paths.end(), isPartOfPart);
  };
  const auto first = std::find_if(program.layers.begin(), program.layers.end(), holdsPart);
  return first == program.layers.end() ? 0 : static_cast<std::size_t>(first - program.layers.begin());
}

/// Layers that would have to be there and are not, without paths [frame of the program], ascending: between
/// layers as many as are as high as the one above them, and above the last one as many as that up to the top
/// of the part. A rest of half a layer is none. Whether the part has
/// material there is not looked at.
/// @param part_height_mm  of its box, from the bottom of the part's first layer
/// @throws InvalidInput if there would be more than a million
std::vector<ToolpathLayer> layersBetween(const Toolpath& program, double part_height_mm) {
  std::vector<ToolpathLayer> missing;
  if (program.layers.empty()) return missing;
  const std::size_t begin = firstOfPart(program);
  for (std::size_t i = begin + 1; i < program.layers.size(); ++i) {
    const ToolpathLayer& layer = program.layers[i];
    addLayers(program.layers[i - 1].z_mm, layer.z_mm - layer.height_mm, layer.height_mm, missing);
  }
  const ToolpathLayer& first = program.layers[begin];
  const ToolpathLayer& last = program.layers.back();
  addLayers(last.z_mm, first.z_mm - first.height_mm + part_height_mm, last.height_mm, missing);
  return missing;
}

/// Of the part above the program: its bottom lies at that of its first layer.
double riseOf(const Toolpath& program, double bottom_mm) {
  if (program.layers.empty()) return 0.0;
  const ToolpathLayer& first = program.layers[firstOfPart(program)];
  return bottom_mm - (first.z_mm - first.height_mm);
}

std::vector<double> cutHeights(const Toolpath& program, double rise_mm) {
  std::vector<double> heights;
  for (const ToolpathLayer& layer : program.layers) {
    heights.push_back(rise_mm + layer.z_mm - 0.5 * layer.height_mm);
    if (heights.size() > 1 && heights.back() <= heights[heights.size() - 2])
      throw InvalidInput("layer " + std::to_string(heights.size() - 1) + " of '" + program.part_name +
                         "' is at " + numberText(layer.z_mm) +
                         " mm, not above the one before; layers must rise");
  }
  return heights;
}

void requireFinite(const Point2& offset) {
  if (offset.allFinite()) return;
  throw InvalidInput("offset of the part is " + numberText(offset.x()) + ", " + numberText(offset.y()) +
                     " mm; must be finite");
}

std::vector<LayerVoids> missingLayers(const Toolpath& program, const SourcePart& source, const Box3& box,
                                      Progress& progress) {
  const std::vector<ToolpathLayer> lacking = layersBetween(program, box.size().z());
  const double rise_mm = riseOf(program, box.low.z());
  std::vector<double> heights;
  heights.reserve(lacking.size());
  for (const ToolpathLayer& layer : lacking) heights.push_back(rise_mm + layer.z_mm - 0.5 * layer.height_mm);
  const std::vector<Section> sections = sliceMesh(source.mesh, source.topology, heights, progress);
  std::vector<LayerVoids> missing;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    LayerVoids layer;
    layer.z_mm = lacking[i].z_mm;
    layer.area_mm2 = area(unite(sections[i].contours));
    layer.uncovered_mm2 = layer.area_mm2;
    if (layer.area_mm2 > 0.0) missing.push_back(layer);
  }
  return missing;
}

}  // namespace

PlacedContours placeContours(const Toolpath& program, const VoidJob& job, Progress& progress) {
  if (job.offset) requireFinite(*job.offset);
  requireLevelLayers(program, "the void map");
  if (job.part.empty()) return {wallContours(program), Point2::Zero(), {}, {}};
  const SourcePart source = grownForShrinkage(readPart(job.part, job.settings.input, progress), job.settings);
  const Box3 box = boundingBox(source.mesh);
  const std::vector<Section> sections =
      sliceMesh(source.mesh, source.topology, cutHeights(program, riseOf(program, box.low.z())), progress);
  PlacedContours placed;
  placed.contours.reserve(sections.size());
  for (const Section& section : sections) placed.contours.push_back(unite(section.contours));
  requireSameSize(program, placed.contours, job.part);
  placed.offset = job.offset ? *job.offset : findPlace(program, placed.contours, box, job);
  for (Regions& contour : placed.contours) contour = moved(std::move(contour), placed.offset);
  placed.other_section = requireSameSections(program, placed.contours, job.part);
  placed.missing = missingLayers(program, source, box, progress);
  return placed;
}

VoidTotals totals(const VoidReport& report) {
  std::vector<LayerVoids> layers = report.layers;
  layers.insert(layers.end(), report.part.missing.begin(), report.part.missing.end());
  VoidTotals sums = totals(layers);
  sums.layers = report.layers.size();
  if (!report.layers.empty())
    sums.runs_per_layer_mean *= static_cast<double>(layers.size()) / static_cast<double>(sums.layers);
  return sums;
}

VoidReport runVoidJob(const Toolpath& program, const VoidJob& job, Progress& progress) {
  VoidReport report;
  report.part = placeContours(program, job, progress);
  report.layers = findVoids(report.part.contours, program, job.map, progress);
  return report;
}

}  // namespace lamina
