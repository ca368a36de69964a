// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/void_job.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "job/part_source.hpp"
#include "job/wall_contours.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/offset.hpp"
#include "lamina/slicing/planar_slicer.hpp"

namespace lamina {
namespace {

constexpr double kRoundPlace = 0.5;  // mm: slicers put the middle of parts on multiples of it
constexpr double kNearRound = 0.2;   // mm
/// Placements are compared on so many layers.
constexpr std::size_t kComparedLayers = 6;

bool isPartOfPart(const Path& path) { return path.role != PathRole::Travel && path.role != PathRole::Skirt; }

Box2 depositedBox(const ToolpathLayer& layer) {
  Box2 box;
  for (const Path& path : layer.paths) {
    if (!isPartOfPart(path)) continue;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const double reach = 0.5 * path.bead.at(i).width_mm;
      box.include(path.points[i].head<2>() - Point2(reach, reach));
      box.include(path.points[i].head<2>() + Point2(reach, reach));
    }
  }
  return box;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Regions moved(Regions regions, const Point2& by) {
  for (Region& region : regions) {
    for (Point2& point : region.outer) point += by;
    for (Polygon& hole : region.holes)
      for (Point2& point : hole) point += by;
  }
  return regions;
}

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

/// Finds where a program has put its part.
class Placing {
 public:
  Placing(const Toolpath& program, const std::vector<Regions>& contours, const VoidMapSettings& map)
      : program_(program), contours_(contours), map_(map) {}

  /// @param centre  of the part's box
  Point2 offset(const Point2& centre) const {
    const Point2 by_boxes = medianOffset();
    const Point2 round = ((centre + by_boxes) / kRoundPlace).array().round() * kRoundPlace;
    const Point2 by_place = round - centre;
    if ((by_place - by_boxes).norm() > kNearRound) return by_boxes;
    return fault(by_place) <= fault(by_boxes) ? by_place : by_boxes;
  }

 private:
  Point2 medianOffset() const {
    std::vector<double> x;
    std::vector<double> y;
    for (std::size_t i = 0; i < contours_.size(); ++i) {
      const Box2 deposited = depositedBox(program_.layers[i]);
      const Box2 cut = boundingBox(outlines(contours_[i]));
      if (deposited.isEmpty() || cut.isEmpty()) continue;
      const Point2 between = deposited.centre() - cut.centre();
      x.push_back(between.x());
      y.push_back(between.y());
    }
    if (x.empty()) return Point2::Zero();
    return {median(std::move(x)), median(std::move(y))};
  }

  /// Area that is uncovered or overfilled.
  double fault(const Point2& offset) const {
    double sum = 0.0;
    const std::size_t step = 1 + (contours_.size() - 1) / kComparedLayers;
    for (std::size_t i = 0; i < contours_.size(); i += step) {
      const LayerVoids voids = findVoids(moved(contours_[i], offset), program_.layers[i], map_);
      sum += voids.uncovered_mm2 + voids.overfill_mm2;
    }
    return sum;
  }

  const Toolpath& program_;
  const std::vector<Regions>& contours_;
  const VoidMapSettings& map_;
};

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
  const Point2 centre = box.centre().head<2>();
  placed.offset = job.offset ? *job.offset : Placing(program, placed.contours, job.map).offset(centre);
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
