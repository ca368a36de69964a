// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/joint_stations.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/toolpath/waypoint_text.hpp"

namespace lamina {
namespace {

constexpr double kShortest = 1e-9;         // mm of the tip
constexpr double kCoincident = 1e-7;       // s that the joints need from one station to the other
constexpr double kStraightStation = 1e-6;  // rad, or rad/mm of the tool axis
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

const Path& pathAt(const Toolpath& toolpath, const WaypointIndex& at) {
  if (at.layer >= toolpath.layers.size() || at.path >= toolpath.layers[at.layer].paths.size() ||
      at.waypoint >= toolpath.layers[at.layer].paths[at.path].points.size())
    throw InvalidInput("a joint path has " + toText(at) + ", which the toolpath has not");
  return toolpath.layers[at.layer].paths[at.path];
}

void requireFitting(const Toolpath& toolpath, const JointPath& path, const KinematicModel& model) {
  if (!path.isRunnable())
    throw Unreachable(toText(path.faults.front().at) + " cannot be run: " + path.faults.front().reason);
  for (const DrivenJoint& joint : model.joints())
    if (!(joint.max_speed > 0.0 && std::isfinite(joint.max_speed)))
      throw InvalidInput("the greatest speed of joint " + joint.name + " is " + numberText(joint.max_speed) +
                         "; must be positive");
  std::size_t expected = 0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& run : layer.paths) expected += run.motionCount() + 1;
  if (path.at.size() != expected || path.values.size() != expected || expected == 0)
    throw InvalidInput("a joint path has " + std::to_string(path.at.size()) + " stations and values of " +
                       std::to_string(path.values.size()) + "; the toolpath has " + std::to_string(expected) +
                       ", and one is needed");
  for (std::size_t i = 0; i < expected; ++i)
    if (path.values[i].size() != static_cast<Eigen::Index>(model.joints().size()) ||
        !path.values[i].allFinite())
      throw InvalidInput("the joint values of " + toText(path.at[i]) + " are not " +
                         std::to_string(model.joints().size()) + " finite numbers");
}

/// Time the joints need at their greatest speeds [s].
double jointTime(const JointValues& from, const JointValues& to, const KinematicModel& model) {
  double time_s = 0.0;
  for (Eigen::Index j = 0; j < from.size(); ++j)
    time_s = std::max(time_s, std::abs(to[j] - from[j]) / model.joints()[j].max_speed);
  return time_s;
}

bool isOnOnePath(const WaypointIndex& a, const WaypointIndex& b) {
  return a.layer == b.layer && a.path == b.path;
}

/// How the way from one waypoint of a path to the next is to be run.
void setMotion(JointStation& station, const Path& path, std::size_t from, const MotionLimits& limits) {
  const std::size_t to = station.heading_for.waypoint;
  if (path.deposit == Deposit::Drops)
    throw InvalidInput(toText(station.heading_for) + " lays drops; joint trajectories lay beads");
  const double feed = path.feed_mm_s.at(to);
  if (!(feed > 0.0 && std::isfinite(feed)))
    throw InvalidInput("the feed to " + toText(station.heading_for) + " is " + numberText(feed) +
                       " mm/s; must be positive");
  const double length_mm = (path.points[to] - path.points[from]).norm();
  if (length_mm < kShortest) return;
  station.length_mm = length_mm;
  station.feed_mm_s = feed;
  const bool is_travel = path.role == PathRole::Travel;
  station.acceleration_mm_s2 = is_travel ? limits.travel_acceleration_mm_s2 : limits.acceleration_mm_s2;
  station.area_mm2 = is_travel ? 0.0 : crossSection(path.bead.at(to));
  station.levels = levelsTo(path, to);
}

/// Whether tip and tool axis keep their direction and rate per length.
bool keepsDirection(const JointStation& before, const JointStation& here, const JointStation& after) {
  if (here.length_mm == 0.0 || after.length_mm == 0.0) return false;
  const auto rate = [](const JointStation& from, const JointStation& to) {
    Eigen::Matrix<double, 6, 1> value;
    value << to.pose.translation() - from.pose.translation(),
        to.pose.linear().col(2) - from.pose.linear().col(2);
    return Eigen::Matrix<double, 6, 1>(value / to.length_mm);
  };
  return (rate(here, after) - rate(before, here)).cwiseAbs().maxCoeff() < kStraightStation;
}

/// The share of the fan once the events before a motion have happened.
double fanAfter(const std::vector<PathEvent>& events, std::size_t motion, double share) {
  for (const PathEvent& placed : eventsBefore(events, motion))
    if (const auto* const fan = std::get_if<FanShare>(&placed.event)) share = fan->share;
  return share;
}

}  // namespace

JointStations jointStations(const Toolpath& toolpath, const JointPath& path, const KinematicModel& model,
                            const MotionLimits& limits) {
  requireFitting(toolpath, path, model);
  JointStations stations;
  stations.each.reserve(path.at.size());
  stations.of_path.reserve(path.at.size());
  std::size_t motion = 0;  // that begins at the station
  double fan = ProcessLevels()[ProcessLevel::Fan];
  for (std::size_t i = 0; i < path.at.size(); ++i) {
    JointStation station;
    station.values = path.values[i];
    station.heading_for = path.at[i];
    station.feed_mm_s = station.acceleration_mm_s2 = kNoLimit;
    const Path& run = pathAt(toolpath, path.at[i]);
    const bool goes_on = i > 0 && isOnOnePath(path.at[i - 1], path.at[i]);
    if (goes_on) setMotion(station, run, path.at[i - 1].waypoint, limits);
    station.levels[ProcessLevel::Fan] = fan;
    motion = goes_on ? motion + 1 : 0;
    const bool is_new = i == 0 || station.length_mm > 0.0 ||
                        jointTime(stations.each.back().values, station.values, model) > kCoincident;
    if (is_new) {
      station.pose = model.bedFromNozzle(station.values);
      stations.each.push_back(std::move(station));
    }
    stations.each.back().dwell_s += dwellBefore(run.events, motion);
    fan = fanAfter(run.events, motion, fan);
    stations.of_path.push_back(stations.each.size() - 1);
  }
  for (const ToolpathEvent& event : toolpath.events_at_end)
    if (const auto* const dwell = std::get_if<Dwell>(&event))
      stations.each.back().dwell_s += dwell->duration_s;
  for (std::size_t i = 1; i + 1 < stations.each.size(); ++i)
    stations.each[i].is_smooth = keepsDirection(stations.each[i - 1], stations.each[i], stations.each[i + 1]);
  return stations;
}

}  // namespace lamina
