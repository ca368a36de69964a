// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/kept_feed.hpp"

#include <cstddef>
#include <vector>

namespace lamina {
namespace {

constexpr int kPlaces = 8;

}  // namespace

double slowBeadShare(const JointTrajectory& trajectory, const JointPath& path, const Toolpath& toolpath) {
  const std::vector<double>& times = trajectory.stationTimes();
  double bead_mm = 0.0;
  double slow_mm = 0.0;
  for (std::size_t i = 1; i < path.at.size(); ++i) {
    const WaypointIndex& at = path.at[i];
    const Path& run = toolpath.layers[at.layer].paths[at.path];
    const bool is_motion = path.at[i - 1].layer == at.layer && path.at[i - 1].path == at.path;
    if (!is_motion || run.role == PathRole::Travel) continue;
    const double step_s = (times[i] - times[i - 1]) / kPlaces;
    for (int place = 0; place < kPlaces; ++place) {
      const double speed = trajectory.at(times[i - 1] + (place + 0.5) * step_s).tip_speed_mm_s;
      bead_mm += speed * step_s;
      if (speed < kKeptFeed * run.feed_mm_s.at(at.waypoint)) slow_mm += speed * step_s;
    }
  }
  return bead_mm > 0.0 ? slow_mm / bead_mm : 0.0;
}

}  // namespace lamina
