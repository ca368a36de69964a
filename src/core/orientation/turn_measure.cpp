// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "orientation/turn_measure.hpp"

#include <cmath>

#include "lamina/orientation/no_spin.hpp"
#include "lamina/orientation/orientation_limits.hpp"
#include "orientation/travel_orientation.hpp"

namespace lamina {
namespace {

void raise(GreatestAngle& greatest, double value, const WaypointIndex& at) {
  if (value > greatest.value) greatest = {value, at};
}

double turnDeg(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  return from.angularDistance(to) * 180.0 / M_PI;
}

void addPath(OrientationReport& report, const Path& path, WaypointIndex at) {
  const std::vector<Eigen::Quaterniond>& values = path.orientation.values();
  for (at.waypoint = 0; at.waypoint < values.size(); ++at.waypoint)
    raise(report.tilt_deg, tiltDeg(toolAxisOf(values[at.waypoint])), at);
  if (path.orientation.isCommon()) return;
  GreatestAngle& per_mm = path.role == PathRole::Travel ? report.travel_deg_per_mm : report.turn_deg_per_mm;
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    at.waypoint = path.motionEnd(m);
    const double turn = turnDeg(values[m], values[at.waypoint]);
    const double length = (path.points[at.waypoint] - path.points[m]).norm();
    raise(report.step_deg, turn, at);
    if (length > 0.0) raise(per_mm, turn / length, at);
  }
}

}  // namespace

OrientationReport measuredTurns(const Toolpath& toolpath) {
  OrientationReport report;
  const Path* before = nullptr;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l) {
    const std::vector<Path>& paths = toolpath.layers[l].paths;
    for (std::size_t p = 0; p < paths.size(); ++p) {
      if (before != nullptr)
        raise(report.step_deg, turnDeg(endOrientation(*before), startOrientation(paths[p])), {l, p, 0});
      addPath(report, paths[p], {l, p, 0});
      before = &paths[p];
    }
  }
  return report;
}

}  // namespace lamina
