// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/kinematic_model_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/kinematics/joint_path/stated_joints.hpp"
#include "lamina/kinematics/joint_path/straight_moves.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/toolpath/toolpath_event.hpp"
#include "lamina/toolpath/waypoint_text.hpp"
#include "lamina/trajectory/kept_feed.hpp"

namespace lamina {
namespace {

/// The same layers, those outside of the stretch without paths.
Toolpath alone(const Toolpath& toolpath, const LayerRange& stretch) {
  Toolpath result;
  result.part_name = toolpath.part_name;
  result.part_from_layers = toolpath.part_from_layers;
  result.layers.resize(toolpath.layers.size());
  std::copy(toolpath.layers.begin() + static_cast<std::ptrdiff_t>(stretch.first),
            toolpath.layers.begin() + static_cast<std::ptrdiff_t>(stretch.end),
            result.layers.begin() + static_cast<std::ptrdiff_t>(stretch.first));
  return result;
}

/// The run with the layers and joints of a stretch put in behind what it has.
KinematicModelRun joined(KinematicModelRun run, DividedJointPath led, const LayerRange& stretch) {
  for (std::size_t l = stretch.first; l < stretch.end; ++l) {
    run.divided.toolpath.layers[l] = std::move(led.divided.toolpath.layers[l]);
    run.divided.original[l] = std::move(led.divided.original[l]);
  }
  const auto append = [](auto& to, auto& from) {
    std::move(from.begin(), from.end(), std::back_inserter(to));
  };
  append(run.path.at, led.joints.at);
  append(run.path.values, led.joints.values);
  append(run.path.faults, led.joints.faults);
  run.path.tool_axis_tolerance = led.joints.tool_axis_tolerance;
  run.path.rewinds += led.joints.rewinds;
  return run;
}

/// Of the waypoints of a run, the index of the one stated that the motion it is on leads to.
/// @param stated  waypoints before they were divided
std::vector<std::size_t> statedAlong(const KinematicModelRun& run, const std::vector<WaypointIndex>& stated) {
  std::vector<std::size_t> along;
  along.reserve(run.path.at.size());
  std::size_t next = 0;
  for (const WaypointIndex& at : run.path.at) {
    const WaypointIndex original = run.divided.originalOf(at);
    while (next + 1 < stated.size() && stated[next] != original) ++next;
    along.push_back(next);
  }
  return along;
}

constexpr double kAtZero = 1e-6;  // rad of a rotary joint

/// Whether a run moves linear axes alone, with all rotary joints at zero.
bool movesLinearAxesAlone(const KinematicModelRun& run, const KinematicModel& model) {
  const std::vector<DrivenJoint>& joints = model.joints();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].kind == JointKind::Linear) continue;
    const auto isAtZero = [j](const JointValues& values) {
      return std::abs(values[static_cast<Eigen::Index>(j)]) <= kAtZero;
    };
    if (!std::all_of(run.path.values.begin(), run.path.values.end(), isAtZero)) return false;
  }
  return true;
}

constexpr double kComesBack = 1e-4;  // rad, mm: the digits of a program

bool isBackAt(const JointValues& one, const JointValues& other) {
  return one.size() == other.size() && one.size() > 0 && (one - other).cwiseAbs().maxCoeff() <= kComesBack;
}

/// The dwells before and after which the joints stand as at a waypoint.
double dwellAt(const KinematicModelRun& run, const std::vector<double>& times, std::size_t waypoint) {
  const std::vector<WaypointIndex>& at = run.path.at;
  std::size_t first = waypoint;  // joints of one station pass it at one time
  while (first > 0 && times[first - 1] == times[waypoint]) --first;
  double dwell_s = 0.0;
  for (std::size_t i = first; i < at.size() && times[i] == times[waypoint]; ++i) {
    std::size_t begin = i;
    while (begin > 0 && at[begin - 1].layer == at[i].layer && at[begin - 1].path == at[i].path) --begin;
    dwell_s += dwellBefore(run.toolpath().layers[at[i].layer].paths[at[i].path].events, i - begin);
  }
  return dwell_s;
}

/// Time along the part of the motions that passages run instead: one that ends elsewhere than it began comes
/// to the next waypoint of the program by itself. What the nozzle dwells before them is run.
double replacedTime(const KinematicModelRun& run, const JointTrajectory& trajectory) {
  const std::vector<double>& times = trajectory.stationTimes();
  const std::vector<JointValues>& values = run.path.values;
  double time_s = 0.0;
  for (const RunPassage& passage : run.passages) {
    const std::size_t begin = passage.joints.before;
    if (begin == 0 || begin >= times.size()) continue;
    const JointValues& last = passage.joints.values.back();
    if (last.size() == 0 || isBackAt(last, values[begin - 1])) continue;
    std::size_t end = begin;  // a motion may be divided, under one line
    while (end + 1 < times.size() && run.lines[end + 1] == run.lines[begin]) ++end;
    if (times[end] > times[begin - 1])
      time_s += times[end] - times[begin - 1] - dwellAt(run, times, begin - 1);
  }
  return time_s;
}

}  // namespace

KinematicModelRun runOn(const CheckedMachine& machine, Toolpath toolpath,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress) {
  return runOn(GuardedModel{machine.model(), machine.guard()}, std::move(toolpath), bed_from_part, settings,
               progress);
}

KinematicModelRun runOn(const GuardedModel& guarded, Toolpath toolpath,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress) {
  DividedJointPath planned =
      planDividedJointPath(std::move(toolpath), bed_from_part, guarded, settings, progress);
  return {std::move(planned.divided), bed_from_part, std::move(planned.joints), {}};
}

KinematicModelRun runOn(const KinematicModel& model, Toolpath toolpath,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress) {
  return runOn(CheckedMachine(model), std::move(toolpath), bed_from_part, settings, progress);
}

KinematicModelRun runOn(const CheckedMachine& machine, const ToolpathExcerpt& excerpt,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress) {
  return runOn(GuardedModel{machine.model(), machine.guard()}, excerpt, bed_from_part, settings, progress);
}

KinematicModelRun runOn(const GuardedModel& guarded, const ToolpathExcerpt& excerpt,
                        const Eigen::Isometry3d& bed_from_part, const JointPathSettings& settings,
                        Progress& progress) {
  KinematicModelRun run{undivided(excerpt.toolpath), bed_from_part, {}, {}};
  for (const LayerRange& stretch : excerpt.stretches)
    run = joined(
        std::move(run),
        planDividedJointPath(alone(excerpt.toolpath, stretch), bed_from_part, guarded, settings, progress),
        stretch);
  return run;
}

KinematicModelRun runAsStated(const KinematicModel& model, StatedMotion motion,
                              const JointPathSettings& settings) {
  KinematicModelRun run;
  run.path = judged(std::move(motion.joints), motion.toolpath, model, settings);
  if (motion.between == StatedMove::Joints) {
    run.divided = undivided(std::move(motion.toolpath));
    run.lines = std::move(motion.lines);
    return run;
  }
  const std::vector<WaypointIndex> stated = run.path.at;
  motion.joints.values = run.path.values;
  run.passages = ledPassages(model, motion, settings);
  run.unknown_way = unknownWay(motion);
  DividedJointPath led = alongStraightMoves(std::move(motion.toolpath), std::move(run.path), model, settings);
  run.divided = std::move(led.divided);
  run.path = std::move(led.joints);
  const std::vector<std::size_t> coarse = statedAlong(run, stated);
  run.lines.reserve(coarse.size());
  for (const std::size_t each : coarse) run.lines.push_back(motion.lines[each]);
  for (RunPassage& passage : run.passages)
    passage.joints.before = static_cast<std::size_t>(
        std::lower_bound(coarse.begin(), coarse.end(), passage.joints.before) - coarse.begin());
  return run;
}

KinematicModelRun passagesAsStated(const KinematicModel& model, StatedMotion motion,
                                   const JointPathSettings& settings) {
  KinematicModelRun run;
  run.passages = ledPassages(model, motion, settings);
  run.unknown_way = unknownWay(motion);
  run.divided = undivided(std::move(motion.toolpath));
  run.path = std::move(motion.joints);
  run.lines = std::move(motion.lines);
  return run;
}

void requireRunnable(const KinematicModelRun& run, const KinematicModel& model) {
  if (run.path.isRunnable()) return;
  const FaultyWaypoint& first = run.path.faults.front();
  throw Unreachable(toText(run.divided.originalOf(first.at)) + ": " + first.reason + " (" +
                    toString(first.fault) + ", the first of " + std::to_string(run.path.faults.size()) +
                    " places that " + model.name() + " cannot run)");
}

TimedRun inTime(KinematicModelRun run, const KinematicModel& model, const TimingSettings& settings) {
  requireRunnable(run, model);
  TimedRun timed;
  timed.trajectory = std::make_unique<TimedPath>(run.toolpath(), run.path, model, settings);
  timed.time = trajectoryTime(*timed.trajectory, run.path, run.toolpath().layers.size());
  timed.figures = {
      timed.time.total_s + passageTime(run.passages, model, settings) - replacedTime(run, *timed.trajectory),
      slowBeadShare(*timed.trajectory, run.path, run.toolpath())};
  timed.run = std::move(run);
  return timed;
}

RunTime plannedTime(const TimedRun& timed, const KinematicModel& model, const MotionLimits& limits) {
  const KinematicModelRun& run = timed.run;
  if (!run.lines.empty() || !movesLinearAxesAlone(run, model)) return timed.figures;
  return {estimateTime(run.toolpath(), limits).total_s, slowBeadShare(run.toolpath(), limits)};
}

}  // namespace lamina
