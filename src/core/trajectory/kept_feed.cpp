// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/kept_feed.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "toolpath/motion_cursor.hpp"

namespace lamina {
namespace {

constexpr int kPlaces = 8;

/// The length of a motion on which the tip is slower than a speed that it need not reach [mm].
double slowLength(const SpeedProfile& profile, double speed_mm_s) {
  if (profile.cruise_mm_s < speed_mm_s) return profile.length_mm;
  const auto ramp = [&](double end_mm_s) {
    const double lacking2 = speed_mm_s * speed_mm_s - end_mm_s * end_mm_s;
    return std::max(0.0, lacking2 / (2.0 * profile.acceleration_mm_s2));
  };
  return std::min(profile.length_mm, ramp(profile.entry_mm_s) + ramp(profile.exit_mm_s));
}

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

double slowBeadShare(const Toolpath& toolpath, const MotionLimits& limits) {
  double bead_mm = 0.0;
  double slow_mm = 0.0;
  MotionCursor motion(toolpath);
  MotionPlanner planner(limits.junction_deviation_mm);
  std::deque<double> feeds_mm_s;  // of motions to be planned; 0 for travels
  const auto take = [&] {
    while (const std::optional<SpeedProfile> profile = planner.next()) {
      if (feeds_mm_s.front() > 0.0) {
        bead_mm += profile->length_mm;
        slow_mm += slowLength(*profile, kKeptFeed * feeds_mm_s.front());
      }
      feeds_mm_s.pop_front();
    }
  };
  while (motion.step()) {
    if (motion.dwell() > 0.0) planner.finish();
    const MotionSegment segment = motion.segment(limits);
    planner.add(segment);
    feeds_mm_s.push_back(motion.path().role == PathRole::Travel ? 0.0 : segment.feed_mm_s);
    take();
  }
  planner.finish();
  take();
  return bead_mm > 0.0 ? slow_mm / bead_mm : 0.0;
}

}  // namespace lamina
