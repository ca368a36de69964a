// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/toolpath.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::array<const char*, 6> kRoleNames = {"skirt",  "outer_wall", "inner_wall",
                                                   "infill", "gap_fill",   "travel"};

}  // namespace

const char* toString(PathRole role) { return kRoleNames.at(static_cast<std::size_t>(role)); }

PathRole pathRoleFromString(const std::string& name) {
  for (std::size_t i = 0; i < kRoleNames.size(); ++i)
    if (name == kRoleNames[i]) return static_cast<PathRole>(i);
  throw InvalidInput("path role is '" + name +
                     "'; must be skirt, outer_wall, inner_wall, infill, gap_fill or travel");
}

std::size_t Path::motionCount() const {
  if (points.empty()) return 0;
  return is_closed ? points.size() : points.size() - 1;
}

Eigen::Quaterniond nozzleDown() { return Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0); }

double length(const Path& path) {
  double sum = 0.0;
  for (std::size_t m = 0; m < path.motionCount(); ++m)
    sum += (path.points[path.motionEnd(m)] - path.points[m]).norm();
  return sum;
}

double crossSection(const Bead& bead) {
  const double high = std::max(bead.width_mm, bead.height_mm);
  const double low = std::min(bead.width_mm, bead.height_mm);
  return (high - low) * low + 0.25 * M_PI * low * low;
}

double depositedVolume(const Path& path) {
  if (path.role == PathRole::Travel) return 0.0;
  if (path.bead.isCommon()) return length(path) * crossSection(path.bead.at(0));
  double sum = 0.0;
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const std::size_t end = path.motionEnd(m);
    sum += (path.points[end] - path.points[m]).norm() * crossSection(path.bead.at(end));
  }
  return sum;
}

ToolpathTotals totals(const Toolpath& toolpath) {
  ToolpathTotals sum;
  sum.layers = toolpath.layers.size();
  for (const ToolpathLayer& layer : toolpath.layers) {
    for (const Path& path : layer.paths) {
      sum.waypoints += path.points.size();
      const bool is_travel = path.role == PathRole::Travel;
      (is_travel ? sum.travel_mm : sum.deposition_mm) += length(path);
      sum.deposition_runs += is_travel ? 0 : 1;
      sum.deposited_mm3 += depositedVolume(path);
    }
  }
  return sum;
}

Box3 depositionBox(const Toolpath& toolpath) {
  Box3 box;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel)
        for (const Point3& point : path.points) box.include(point);
  return box;
}

}  // namespace lamina
