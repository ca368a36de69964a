// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "waypoint_count.hpp"

#include <algorithm>
#include <utility>

namespace lamina {

WaypointCount::WaypointCount(const Toolpath& toolpath) {
  first_.reserve(toolpath.layers.size());
  for (const ToolpathLayer& layer : toolpath.layers) {
    std::vector<std::uint64_t> paths;
    paths.reserve(layer.paths.size());
    for (const Path& path : layer.paths) {
      paths.push_back(total_);
      total_ += path.points.size() + (path.is_closed ? 1 : 0);
    }
    first_.push_back(std::move(paths));
  }
}

std::uint64_t WaypointCount::before(const WaypointIndex& waypoint) const {
  if (waypoint.layer >= first_.size() || waypoint.path >= first_[waypoint.layer].size()) return 0;
  return first_[waypoint.layer][waypoint.path] + waypoint.waypoint;
}

void WaypointCount::see(const WaypointIndex& heading_for, const WaypointIndex& handed_over_for) {
  // The first waypoint of a closed path is headed for twice: what was reached stays reached.
  reached_ = std::max(reached_, before(heading_for));
  handed_over_ = std::max({handed_over_, reached_, std::min(total_, before(handed_over_for) + 1)});
}

void WaypointCount::complete() { reached_ = handed_over_ = total_; }

}  // namespace lamina
