// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/joint_path/divided_joint_path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/space_vectors.hpp"
#include "kinematics/joint_path/joint_planning.hpp"
#include "kinematics/model/joint_ranges.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/parallel.hpp"

namespace lamina {

namespace {

constexpr int kMostSteps = 64;                   // that a motion is divided into at once
constexpr std::size_t kKeptBytes = 512'000'000;  // of rungs, from one division to the next

MotionDeviation deviation(const JointValues& from, const JointValues& to, const KinematicModel& model) {
  const Eigen::Isometry3d start = model.bedFromNozzle(from);
  const Eigen::Isometry3d end = model.bedFromNozzle(to);
  const Eigen::Isometry3d half = model.bedFromNozzle(0.5 * (from + to));
  const Point3 middle = 0.5 * (start.translation() + end.translation());
  const Eigen::Quaterniond turned =
      Eigen::Quaterniond(start.linear()).slerp(0.5, Eigen::Quaterniond(end.linear()));
  Point3 tool_axis = turned * Point3::UnitZ();
  if (model.toolAxisSpin() == ToolAxisSpin::Free) {
    const Point3 mean = start.linear().col(2) + end.linear().col(2);
    if (mean.norm() > 0.0) tool_axis = mean;
  }
  return {(half.translation() - middle).norm(), angleBetween(tool_axis, half.linear().col(2))};
}

bool isSteady(const JointValues& from, const JointValues& to, const std::vector<JointRange>& ranges,
              double most_turn) {
  for (std::size_t j = 0; j < ranges.size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    if (ranges[j].is_rotary && std::abs(to[index] - from[index]) > most_turn) return false;
  }
  return true;
}

/// The deviation of a motion that is curved shrinks with the square of the steps.
int stepsFor(const MotionDeviation& deviation, const MotionDivision& division) {
  const double excess = std::max(deviation.tip_mm / division.tip_tolerance_mm,
                                 deviation.tool_axis / toRadians(division.tool_axis_tolerance_deg));
  if (!(excess > 1.0)) return 1;
  return std::min(kMostSteps, std::max(2, static_cast<int>(std::ceil(std::sqrt(excess)))));
}

/// Where the joints start anew by whole turns, for each waypoint: both lists are in the order of the motion.
std::vector<char> unwindingAt(const JointPath& path) {
  std::vector<char> is_wound_up(path.at.size(), 0);
  std::size_t i = 0;
  for (const FaultyWaypoint& faulty : path.faults) {
    while (i + 1 < path.at.size() && path.at[i] != faulty.at) ++i;
    if (faulty.fault == JointFault::JointUnwinding) is_wound_up[i] = 1;
  }
  return is_wound_up;
}

MotionDeviation greatestOf(const std::vector<MotionDeviation>& deviations) {
  MotionDeviation greatest;
  for (const MotionDeviation& one : deviations) {
    greatest.tip_mm = std::max(greatest.tip_mm, one.tip_mm);
    greatest.tool_axis = std::max(greatest.tool_axis, one.tool_axis);
  }
  return greatest;
}

}  // namespace

std::vector<MotionDeviation> motionDeviations(const JointPath& path, const Toolpath& toolpath,
                                              const KinematicModel& model,
                                              const JointPathSettings& settings) {
  const std::vector<JointRange> ranges = jointRanges(model.joints());
  const double most_turn = toRadians(settings.max_turn_deg);
  const std::vector<char> is_wound_up = unwindingAt(path);
  std::vector<MotionDeviation> deviations(path.at.size());
  NoProgress silent;
  const auto measure = [&](std::size_t i) {
    if (i == 0 || path.values[i].size() == 0 || path.values[i - 1].size() == 0) return;
    const WaypointIndex& at = path.at[i];
    const WaypointIndex& before = path.at[i - 1];
    if (at.layer != before.layer || at.path != before.path) return;
    const bool is_travel = toolpath.layers[at.layer].paths[at.path].role == PathRole::Travel;
    if (is_wound_up[i]) return;
    if (is_travel && !isSteady(path.values[i - 1], path.values[i], ranges, most_turn)) return;
    deviations[i] = deviation(path.values[i - 1], path.values[i], model);
  };
  parallelFor(path.at.size(), measure, silent, "joints");
  return deviations;
}

std::vector<int> stepsAgainst(const std::vector<MotionDeviation>& deviations,
                              const MotionDivision& division) {
  std::vector<int> steps;
  steps.reserve(deviations.size());
  for (const MotionDeviation& one : deviations) steps.push_back(stepsFor(one, division));
  return steps;
}

DividedJointPath planDividedJointPath(Toolpath toolpath, const Eigen::Isometry3d& bed_from_part,
                                      const KinematicModel& model, const JointPathSettings& settings,
                                      Progress& progress) {
  return planDividedJointPath(std::move(toolpath), bed_from_part, {model, NoGuard()}, settings, progress);
}

DividedJointPath planDividedJointPath(Toolpath toolpath, const Eigen::Isometry3d& bed_from_part,
                                      const GuardedModel& guarded, const JointPathSettings& settings,
                                      Progress& progress) {
  validate(settings);
  RungStore rungs(kKeptBytes);
  DividedJointPath result;
  result.divided = divideMotions(std::move(toolpath), settings.division);
  for (int division = 0;; ++division) {
    result.joints = planJointPath(result.divided.toolpath, bed_from_part,
                                  JointPlanning{guarded, settings, rungs}, progress);
    const std::vector<MotionDeviation> deviations =
        motionDeviations(result.joints, result.divided.toolpath, guarded.model, settings);
    result.greatest = greatestOf(deviations);
    const std::vector<int> steps = stepsAgainst(deviations, settings.division);
    const bool is_close = std::all_of(steps.begin(), steps.end(), [](int count) { return count == 1; });
    if (is_close || division == kMostDivisions) return result;
    result.divided = divided(result.divided, steps);
  }
}

}  // namespace lamina
