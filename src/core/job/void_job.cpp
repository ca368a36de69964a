// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/void_job.hpp"

#include <utility>

#include "job/part_placing.hpp"
#include "job/part_source.hpp"
#include "job/wall_contours.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/offset.hpp"
#include "lamina/slicing/planar_slicer.hpp"

namespace lamina {
namespace {

/// The bottom of the part lies at that of the first layer.
std::vector<double> cutHeights(const Toolpath& program, double bottom_mm) {
  std::vector<double> heights;
  if (program.layers.empty()) return heights;
  const double rise_mm = bottom_mm - (program.layers.front().z_mm - program.layers.front().height_mm);
  for (const ToolpathLayer& layer : program.layers) {
    heights.push_back(rise_mm + layer.z_mm - 0.5 * layer.height_mm);
    if (heights.size() > 1 && heights.back() <= heights[heights.size() - 2])
      throw InvalidInput("layer " + std::to_string(heights.size() - 1) + " of '" + program.part_name +
                         "' is at " + std::to_string(layer.z_mm) +
                         " mm, not above the one before; layers must rise");
  }
  return heights;
}

}  // namespace

PlacedContours placeContours(const Toolpath& program, const VoidJob& job, Progress& progress) {
  if (job.part.empty()) return {wallContours(program), Point2::Zero()};
  const SourcePart source = readPart(job.part, job.settings.input);
  const Box3 box = boundingBox(source.mesh);
  const std::vector<Section> sections =
      sliceMesh(source.mesh, source.topology, cutHeights(program, box.low.z()), progress);
  PlacedContours placed;
  placed.contours.reserve(sections.size());
  for (const Section& section : sections) placed.contours.push_back(unite(section.contours));
  placed.offset = job.offset ? *job.offset : findPlace(program, placed.contours, box, job);
  for (Regions& contour : placed.contours) contour = moved(std::move(contour), placed.offset);
  return placed;
}

VoidReport runVoidJob(const Toolpath& program, const VoidJob& job, Progress& progress) {
  VoidReport report;
  report.part = placeContours(program, job, progress);
  report.layers = findVoids(report.part.contours, program, job.map, progress);
  return report;
}

}  // namespace lamina
