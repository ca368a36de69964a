// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/joint_path/joint_path_planner.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "kinematics/joint_path/joint_planning.hpp"
#include "kinematics/joint_path/joint_unwinding.hpp"
#include "kinematics/joint_path/redundancy_ladder.hpp"
#include "kinematics/joint_path/station_joints.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/arm/abb_configuration.hpp"

namespace lamina {

namespace {

constexpr double kLiftedRank = 1e9;  // mm: above the length of any travel

std::vector<WindLink> windLinks(const std::vector<StationJoints>& joints,
                                const std::vector<Station>& stations) {
  std::vector<WindLink> links(joints.size());
  for (std::size_t i = 1; i < joints.size(); ++i) {
    const StationMotion& motion = stations[i].motion;
    links[i].is_linked = joints[i].is_linked;
    links[i].may_rewind = motion.way == StationWay::ClearTravel;
    links[i].rank = motion.length_mm + (motion.lift_mm > 0.0 ? kLiftedRank : 0.0);
  }
  return links;
}

/// How much of its limits a joint needs, and by how much it would have to begin elsewhere.
std::string neededTurn(const WoundUp& at, const JointRange& range) {
  const double needed = at.highest - at.lowest;
  const double held = range.high - range.low;
  std::string text = "; it turns by " + angleText(needed) + " there, of " + angleText(held);
  if (needed > held) return text;
  double least = range.low - at.lowest;
  double most = range.high - at.highest;
  const double whole = 2.0 * M_PI * std::round((least + most) / (4.0 * M_PI));
  least -= whole;
  most -= whole;
  return text + ", and fits if it begins " + angleText(std::min(std::abs(least), std::abs(most))) + " to " +
         angleText(std::max(std::abs(least), std::abs(most))) + (most > 0.0 ? " higher" : " lower") +
         " (another start of the loop, or the bed turned)";
}

StationFault woundUp(const WoundUp& at, const RungSolver& solver, const KinematicModel& model) {
  const JointRange& range = solver.ranges()[at.joint];
  return {at.index, JointFault::JointUnwinding,
          "joint " + model.joints()[at.joint].name + " runs out of its limits, " +
              jointValueText(range, range.low) + " to " + jointValueText(range, range.high) +
              ", since the travel before, and would have to be wound back while depositing" +
              neededTurn(at, range)};
}

/// Whole turns for all stations; adds where they cannot be chosen.
Unwound unwindStations(StationWayThrough& way, const StationTask& task) {
  std::vector<JointValues> values;
  values.reserve(way.stations.size());
  for (const StationJoints& here : way.stations) values.push_back(here.values);
  Unwound unwound = unwind(std::move(values), windLinks(way.stations, task.stations), task.solver.ranges());
  for (std::size_t i = 0; i < way.stations.size(); ++i) way.stations[i].values = unwound.values[i];
  for (const WoundUp& at : unwound.wound_up) {
    way.stations[at.index].is_linked = false;
    way.faults.push_back(woundUp(at, task.solver, task.model));
  }
  return unwound;
}

/// An arm whose nozzle no joint turns about its tool axis cannot hold that turn.
void requireYawOf(const KinematicModel& model, const JointPathSettings& settings) {
  if (settings.yaw != YawChoice::Held || !isArm(model) || model.toolAxisSpin() == ToolAxisSpin::Given) return;
  throw InvalidConfig("joints.yaw is held, but the arm '" + model.name() +
                      "' has five axes, none of which is its tool axis; expected free");
}

JointPath jointPathOf(const StationList& list, StationWayThrough way, std::size_t rewinds) {
  JointPath path;
  path.rewinds = rewinds;
  path.values.reserve(list.waypoints.size());
  for (const std::uint32_t station : list.station_of) path.values.push_back(way.stations[station].values);
  std::stable_sort(way.faults.begin(), way.faults.end(),
                   [](const StationFault& a, const StationFault& b) { return a.station < b.station; });
  // Every waypoint that has no values is named, those that share a station too.
  for (const StationFault& fault : way.faults) {
    std::size_t waypoint = list.waypoint_of[fault.station];
    const bool has_values = way.stations[fault.station].values.size() > 0;
    do {
      path.faults.push_back({list.waypoints[waypoint], fault.fault, fault.reason});
      ++waypoint;
    } while (!has_values && waypoint < list.waypoints.size() && list.station_of[waypoint] == fault.station);
  }
  path.at = list.waypoints;
  return path;
}

/// A path, and the joints that wind up on it.
struct PlannedPath {
  JointPath path;
  std::vector<std::size_t> wound_up;
};

PlannedPath planWithin(std::vector<JointRange> ranges, const StationList& list, const JointPlanning& planning,
                       Progress& progress) {
  const JointPathSettings& settings = planning.settings;
  const RungSolver solver(planning.guarded, settings, std::move(ranges));
  const StationTask task{list.stations, planning.guarded.model, solver, settings};
  StationWayThrough way = searchLadder(task, planning.rungs, progress);
  if (settings.is_yaw_smoothed) smoothSamples(way.stations, task, progress);
  steadySwings(way.stations, task);
  const Unwound unwound = unwindStations(way, task);
  std::vector<StationFault> slow = slowPassages(way.stations, task);
  std::move(slow.begin(), slow.end(), std::back_inserter(way.faults));
  PlannedPath planned;
  planned.path = jointPathOf(list, std::move(way), unwound.rewinds);
  planned.wound_up.reserve(unwound.wound_up.size());
  for (const WoundUp& at : unwound.wound_up) planned.wound_up.push_back(at.joint);
  return planned;
}

/// The ladder takes no account of whole turns, and thus may go where a joint winds up although another way
/// leaves no limit. Such joints are then led as if they could not wind: the ladder sees their limits.
/// @return the path with wound up joints, if there is none without any fault
JointPath planUnwound(const StationList& list, const JointPlanning& planning, Progress& progress) {
  std::vector<JointRange> ranges = jointRanges(planning.guarded.model.joints());
  PlannedPath first = planWithin(ranges, list, planning, progress);
  RungStore nothing(0);  // rungs hold penalties, which are others near limits that do not wind
  const JointPlanning anew{planning.guarded, planning.settings, nothing};
  std::vector<std::size_t> wound_up = first.wound_up;
  while (!wound_up.empty()) {
    for (const std::size_t joint : wound_up) ranges[joint].winds = false;
    PlannedPath next = planWithin(ranges, list, anew, progress);
    if (next.path.isRunnable()) return std::move(next.path);
    wound_up = std::move(next.wound_up);
  }
  return std::move(first.path);
}

}  // namespace

JointPath planJointPath(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                        const KinematicModel& model, const JointPathSettings& settings, Progress& progress) {
  return planJointPath(toolpath, bed_from_part, {model, NoGuard()}, settings, progress);
}

JointPath planJointPath(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                        const GuardedModel& guarded, const JointPathSettings& settings, Progress& progress) {
  RungStore nothing(0);
  return planJointPath(toolpath, bed_from_part, JointPlanning{guarded, settings, nothing}, progress);
}

JointPath planJointPath(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                        const JointPlanning& planning, Progress& progress) {
  const GuardedModel& guarded = planning.guarded;
  const JointPathSettings& settings = planning.settings;
  validate(settings);
  requireYawOf(guarded.model, settings);
  StationList list = stationsOf(toolpath, bed_from_part, settings.tool_offsets_mm);
  if (list.stations.empty()) return {};
  setExternalAxes(list.stations, guarded.model, settings);
  resolveRedundancy(list.stations, guarded, settings, progress);
  JointPath path = planUnwound(list, planning, progress);
  path.tool_axis_tolerance =
      toRadians(std::max(settings.swing_tolerance_deg, settings.singular_tool_axis_tolerance_deg));
  return path;
}

}  // namespace lamina
