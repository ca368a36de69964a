// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/part/copies.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/toolpath/layer_frame.hpp"

namespace lamina {
namespace {

/// The endless edge of a build space as the part sees it.
struct Belt {
  Point3 direction = Point3::Zero();  ///< in which its value grows, of unit length [part frame]
  Eigen::RowVector3d row;             ///< its value from a point of the part, less a constant

  double offset = 0.0;  ///< that constant

  double valueAt(const Point3& point) const { return row * point; }
};

/// Of the belt's value over what is deposited; empty if nothing is.
struct BeltSpan {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

/// What needs a belt, and what is expected without one, for messages.
struct BeltUse {
  std::string asked;
  std::string expected;
};

BeltUse useByPlate() { return {"the plate has parts in inclined layers", "level layers, or one part"}; }

Belt beltOf(const BuildSpace& space, const Eigen::Isometry3d& bed_from_part, const BeltUse& use) {
  for (int i = 0; i < 3; ++i) {
    if (!space.is_endless[static_cast<std::size_t>(i)]) continue;
    const Eigen::Affine3d axes_from_part = space.bed_from_axes.inverse() * bed_from_part;
    return {bed_from_part.linear().transpose() * space.bed_from_axes.linear().col(i),
            axes_from_part.linear().row(i), axes_from_part.translation()[i]};
  }
  throw InvalidConfig(use.asked + ", and the machine " + space.name + " has no belt; expected " +
                      use.expected);
}

BeltSpan spanOf(const Toolpath& toolpath, const Belt& belt) {
  BeltSpan span;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      if (path.role == PathRole::Travel) continue;
      for (const Point3& point : path.points) {
        span.low = std::min(span.low, belt.valueAt(point));
        span.high = std::max(span.high, belt.valueAt(point));
      }
    }
  return span;
}

bool isEmpty(const BeltSpan& span) { return span.high < span.low; }

/// How far the belt goes while the toolpath deposits [mm].
double wayOf(const Toolpath& toolpath, const Belt& belt) {
  const BeltSpan span = spanOf(toolpath, belt);
  return std::max(0.0, span.high - span.low);
}

std::vector<ToolpathLayer> moved(std::vector<ToolpathLayer> layers, const Point3& by, const Point3& normal) {
  for (ToolpathLayer& layer : layers) {
    layer.z_mm += normal.dot(by);
    for (Path& path : layer.paths)
      for (Point3& point : path.points) point += by;
  }
  return layers;
}

/// Along the belt first, then across.
Path travelBetween(const Point3& from, const Point3& to, const Belt& belt, double feed_mm_s) {
  Path travel;
  travel.role = PathRole::Travel;
  travel.process.is_retracted = true;
  travel.feed_mm_s = feed_mm_s;
  travel.bead = Bead{};
  travel.points = {from};
  const Point3 amid = from + (belt.valueAt(to) - belt.valueAt(from)) * belt.direction;
  for (const Point3& point : {amid, to})
    if (point != travel.points.back()) travel.points.push_back(point);
  return travel;
}

Path& lastPathOf(std::vector<ToolpathLayer>& layers) {
  return std::find_if(layers.rbegin(), layers.rend(), [](const auto& layer) { return !layer.paths.empty(); })
      ->paths.back();
}

PathEvent markOf(const std::string& part, std::size_t motion) {
  PathEvent event;
  event.motion = motion;
  event.event.emplace<PartMark>(PartMark{part});
  return event;
}

/// Before the first path.
void markStart(const std::string& part, std::vector<ToolpathLayer>& layers) {
  const auto first =
      std::find_if(layers.begin(), layers.end(), [](const auto& layer) { return !layer.paths.empty(); });
  std::vector<PathEvent>& events = first->paths.front().events;
  events.insert(events.begin(), markOf(part, 0));
}

/// Behind the last path, so that the way to the next part is of that part.
void markEnd(const std::string& part, std::vector<ToolpathLayer>& layers) {
  Path& last = lastPathOf(layers);
  last.events.push_back(markOf(part, last.motionCount()));
}

/// Lays layers after all that there is, on the way along the belt.
void append(Toolpath& toolpath, std::vector<ToolpathLayer> next, const Belt& belt, double travel_feed_mm_s) {
  const auto first =
      std::find_if(next.begin(), next.end(), [](const auto& layer) { return !layer.paths.empty(); });
  if (first == next.end()) return;
  const Path& before = lastPathOf(toolpath.layers);
  Path travel = travelBetween(before.lastPoint(), first->paths.front().firstPoint(), belt, travel_feed_mm_s);
  travel.orientation = before.orientation.at(0);
  travel.tool = first->paths.front().tool;
  if (travel.points.size() > 1) first->paths.insert(first->paths.begin(), std::move(travel));
  std::move(next.begin(), next.end(), std::back_inserter(toolpath.layers));
}

}  // namespace

void describe(SettingsSchema& schema, CopySettings& settings) {
  schema.integer("part.copies", settings.count, {1, 1000}, "How often a belt printer prints the part.");
  schema.number("part.spacing_mm", settings.spacing_mm, {0.0, 1e5},
                "Way of the belt between one copy's end and the next one's start.");
}

Toolpath withCopies(Toolpath toolpath, const CopySettings& settings, const BuildSpace& space,
                    const Eigen::Isometry3d& bed_from_part, double travel_feed_mm_s) {
  if (settings.count == 1) return toolpath;
  const Belt belt = beltOf(space, bed_from_part, {"part.copies is " + std::to_string(settings.count), "1"});
  const Point3 step = (wayOf(toolpath, belt) + settings.spacing_mm) * belt.direction;
  const Point3 normal = layerNormal(toolpath);
  const std::vector<ToolpathLayer> one = toolpath.layers;
  toolpath.layers.reserve(one.size() * static_cast<std::size_t>(settings.count));
  for (int copy = 1; copy < settings.count; ++copy)
    append(toolpath, moved(one, static_cast<double>(copy) * step, normal), belt, travel_feed_mm_s);
  return toolpath;
}

std::vector<Point3> placesAlongBelt(const std::vector<BeltPart>& parts, double spacing_mm,
                                    const BuildSpace& space) {
  std::vector<Point3> places;
  std::optional<double> end;
  for (const BeltPart& part : parts) {
    const Belt belt = beltOf(space, part.bed_from_part, useByPlate());
    const BeltSpan span = spanOf(*part.toolpath, belt);
    const double begin = span.low + belt.offset;
    const double way = end && !isEmpty(span) ? *end + spacing_mm - begin : 0.0;
    places.push_back(way * (part.bed_from_part.linear() * belt.direction));
    if (!isEmpty(span)) end = span.high + belt.offset + way;
  }
  return places;
}

Toolpath oneAfterAnother(const std::vector<BeltPart>& parts, const std::vector<Point3>& places,
                         const BuildSpace& space, double travel_feed_mm_s) {
  Toolpath all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const BeltPart& part = parts[i];
    const Eigen::Isometry3d& bed_from_first = parts.front().bed_from_part;
    const Belt belt = beltOf(space, bed_from_first, useByPlate());
    const Point3 by = bed_from_first.linear().transpose() *
                      (part.bed_from_part.translation() + places[i] - bed_from_first.translation());
    std::vector<ToolpathLayer> layers = moved(part.toolpath->layers, by, layerNormal(*part.toolpath));
    if (i == 0) {
      all = *part.toolpath;
      all.layers.clear();
    }
    if (isEmpty(spanOf(*part.toolpath, belt))) continue;
    if (all.layers.empty()) {
      all.layers = std::move(layers);
      markStart(part.name, all.layers);
      continue;
    }
    markEnd(part.name, all.layers);
    append(all, std::move(layers), belt, travel_feed_mm_s);
  }
  return all;
}

}  // namespace lamina
