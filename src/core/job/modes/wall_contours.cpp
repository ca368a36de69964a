// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/wall_contours.hpp"

#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

/// Other slicers end a loop a little short of where it starts.
bool isLoop(const Path& path) {
  const Point3 gap = path.lastPoint() - path.firstPoint();
  return path.points.size() > 2 && gap.norm() <= path.bead.at(0).width_mm;
}

Polygon flat(const Path& path) {
  Polygon loop;
  loop.reserve(path.points.size());
  for (const Point3& point : path.points) loop.emplace_back(point.head<2>());
  if (signedArea(loop) < 0.0) std::reverse(loop.begin(), loop.end());
  return loop;
}

/// What is in one of them only.
Regions symmetricDifference(const Regions& a, const Regions& b) {
  std::vector<Polygon> borders = outlines(difference(a, b));
  for (Polygon& outline : outlines(difference(b, a))) borders.push_back(std::move(outline));
  return unite(borders);
}

}  // namespace

Regions wallContour(const ToolpathLayer& layer) {
  Regions inside;
  double width = 0.0;
  for (const Path& path : layer.paths) {
    if (path.role != PathRole::OuterWall || !isLoop(path)) continue;
    inside = symmetricDifference(inside, unite({flat(path)}));
    width = std::max(width, path.bead.at(0).width_mm);
  }
  return offset(inside, 0.5 * width);
}

std::vector<Regions> wallContours(const Toolpath& program) {
  std::vector<Regions> contours;
  contours.reserve(program.layers.size());
  for (const ToolpathLayer& layer : program.layers) contours.push_back(wallContour(layer));
  if (std::all_of(contours.begin(), contours.end(), [](const Regions& each) { return each.empty(); }))
    throw InvalidInput("'" + program.part_name +
                       "' has no closed outer wall in any layer; the part it fills must be given");
  return contours;
}

}  // namespace lamina
