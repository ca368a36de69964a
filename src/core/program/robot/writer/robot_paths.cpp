// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/robot/writer/robot_paths.hpp"

#include <cmath>

#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr double kFarthest = 1e5;     // mm: beyond any robot
constexpr double kSamePose = 1e-6;    // mm and rad: under what targets resolve
constexpr double kUnitLength = 1e-6;  // of a quaternion

void requireBeads(const RobotPath& at) {
  for (std::size_t i = 0; i < at.path->bead.values().size(); ++i) {
    const Bead& bead = at.path->bead.at(i);
    if (!(bead.width_mm >= 0.0 && bead.height_mm >= 0.0 && std::isfinite(crossSection(bead))))
      refuseWaypoint(at, i, "bead width and height must be finite and not negative");
  }
}

/// Refuses what no program can express, naming the place.
void requireWritable(const RobotPath& at) {
  const Path& path = *at.path;
  if (path.deposit == Deposit::Drops)
    refuseWaypoint(at, 0, "drops are deposited; a robot's program deposits beads only");
  if (path.points.size() < 2) refuseWaypoint(at, path.points.size(), "a path needs at least 2 waypoints");
  for (std::size_t i = 0; i < path.points.size(); ++i)
    if (path.points[i].hasNaN() || path.points[i].cwiseAbs().maxCoeff() >= kFarthest)
      refuseWaypoint(at, i, "the position is not a number within 100 m");
  requireWritableFeeds(at);
  for (std::size_t i = 0; i < path.orientation.values().size(); ++i)
    if (!(std::abs(path.orientation.at(i).norm() - 1.0) <= kUnitLength))
      refuseWaypoint(at, i, "the orientation is no quaternion of unit length");
  if (at.deposits()) requireBeads(at);
}

void addSwitches(std::vector<RobotPath>& paths, ToolTurns turns) {
  paths.front().is_turned = true;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    RobotPath& path = paths[p];
    const RobotPath* before = p > 0 ? &paths[p - 1] : nullptr;
    if (before != nullptr && turns == ToolTurns::Any)
      path.is_turned =
          endOrientation(*before->path).angularDistance(path.path->orientation.at(0)) > kSamePose;
    const bool goes_on = before != nullptr && before->deposits() && path.deposits() && !path.is_turned;
    path.switches_on = path.deposits() && !goes_on;
    if (before != nullptr) paths[p - 1].switches_off = before->deposits() && !goes_on;
  }
  paths.back().switches_off = paths.back().deposits();
}

}  // namespace

std::vector<RobotPath> robotPaths(const Toolpath& toolpath, ToolTurns turns) {
  std::vector<RobotPath> paths;
  for (const ListedPath& listed : listedPaths(toolpath)) {
    RobotPath path;
    static_cast<ListedPath&>(path) = listed;
    paths.push_back(path);
  }
  for (const RobotPath& path : paths) requireWritable(path);
  addSwitches(paths, turns);
  return paths;
}

double dwellAfter(const Toolpath& toolpath, const std::vector<RobotPath>& paths, std::size_t path,
                  std::size_t move) {
  const RobotPath& at = paths[path];
  double sum_s = dwellBefore(at.path->events, move + 1 - at.turnCount());
  if (move + 1 < at.moveCount()) return sum_s;
  if (path + 1 < paths.size()) {
    const RobotPath& next = paths[path + 1];
    return sum_s + (next.is_turned ? 0.0 : dwellBefore(next.path->events, 0));
  }
  for (const ToolpathEvent& event : toolpath.events_at_end)
    if (const auto* const dwell = std::get_if<Dwell>(&event)) sum_s += dwell->duration_s;
  return sum_s;
}

std::vector<RobotStretch> robotStretches(const std::vector<RobotPath>& paths) {
  std::vector<RobotStretch> stretches;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    if (p == 0 || paths[p - 1].switches_off) stretches.push_back({p, p, 0});
    stretches.back().end = p + 1;
    stretches.back().points += paths[p].moveCount();
  }
  return stretches;
}

}  // namespace lamina
