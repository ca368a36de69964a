// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/part/copies.hpp"

#include <algorithm>
#include <limits>
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

  double valueAt(const Point3& point) const { return row * point; }
};

Belt beltOf(const BuildSpace& space, const Eigen::Isometry3d& bed_from_part, int copies) {
  for (int i = 0; i < 3; ++i) {
    if (!space.is_endless[static_cast<std::size_t>(i)]) continue;
    const Eigen::Affine3d axes_from_part = space.bed_from_axes.inverse() * bed_from_part;
    return {bed_from_part.linear().transpose() * space.bed_from_axes.linear().col(i),
            axes_from_part.linear().row(i)};
  }
  throw InvalidConfig("part.copies is " + std::to_string(copies) + ", and the machine " + space.name +
                      " has no belt; expected 1");
}

/// How far the belt goes while the toolpath deposits [mm].
double wayOf(const Toolpath& toolpath, const Belt& belt) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) {
      if (path.role == PathRole::Travel) continue;
      for (const Point3& point : path.points) {
        low = std::min(low, belt.valueAt(point));
        high = std::max(high, belt.valueAt(point));
      }
    }
  return std::max(0.0, high - low);
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

const Path& lastPath(const std::vector<ToolpathLayer>& layers) {
  return std::find_if(layers.rbegin(), layers.rend(), [](const auto& layer) { return !layer.paths.empty(); })
      ->paths.back();
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
  const Belt belt = beltOf(space, bed_from_part, settings.count);
  const Point3 step = (wayOf(toolpath, belt) + settings.spacing_mm) * belt.direction;
  const Point3 normal = layerNormal(toolpath);
  const std::vector<ToolpathLayer> one = toolpath.layers;
  toolpath.layers.reserve(one.size() * static_cast<std::size_t>(settings.count));
  for (int copy = 1; copy < settings.count; ++copy) {
    std::vector<ToolpathLayer> next = moved(one, static_cast<double>(copy) * step, normal);
    const auto first =
        std::find_if(next.begin(), next.end(), [](const auto& layer) { return !layer.paths.empty(); });
    if (first == next.end()) return toolpath;
    const Path& before = lastPath(toolpath.layers);
    Path travel =
        travelBetween(before.lastPoint(), first->paths.front().firstPoint(), belt, travel_feed_mm_s);
    travel.orientation = before.orientation.at(0);
    travel.tool = first->paths.front().tool;
    if (travel.points.size() > 1) first->paths.insert(first->paths.begin(), std::move(travel));
    std::move(next.begin(), next.end(), std::back_inserter(toolpath.layers));
  }
  return toolpath;
}

}  // namespace lamina
