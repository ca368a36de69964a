// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "kinematics/joint_path/evened_angles.hpp"
#include "kinematics/joint_path/station_joints.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/parallel.hpp"

namespace lamina {

namespace {

class SampleSmoothing {
 public:
  SampleSmoothing(std::vector<StationJoints>& joints, const StationTask& task)
      : joints_(joints), stations_(task.stations), solver_(task.solver), settings_(task.settings) {}

  /// One past the last station of the run that starts here.
  std::size_t runEnd(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (end < joints_.size() && goesOn(end)) ++end;
    return end;
  }

  void smooth(std::size_t begin, std::size_t end) {
    std::vector<double> angles;
    angles.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i)
      angles.push_back(solver_.coordinateOf(joints_[i].kind, joints_[i].node));
    const std::vector<double> even = evenedOut(angles, 2.0 * M_PI / settings_.yaw_samples);
    std::vector<JointValues> values;
    values.reserve(even.size());
    for (std::size_t i = begin; i < end; ++i) {
      const auto found =
          solver_.at(stations_[i], joints_[i].kind, even[i - begin], branchOf(joints_[i].node));
      if (!found) return;
      values.push_back(*found);
      if (i > begin && !isSteady(values[i - begin - 1], *found, i)) return;
    }
    for (std::size_t i = begin; i < end; ++i) joints_[i].values = values[i - begin];
  }

 private:
  /// The same branch, and samples near to those of the station before.
  bool goesOn(std::size_t i) const {
    const StationJoints& before = joints_[i - 1];
    const StationJoints& here = joints_[i];
    if (!here.is_linked || here.kind != before.kind || branchOf(here.node) != branchOf(before.node))
      return false;
    const int apart = std::abs(sampleOf(here.node) - sampleOf(before.node));
    return std::min(apart, settings_.yaw_samples - apart) <= settings_.yaw_reach;
  }

  bool isSteady(const JointValues& from, const JointValues& to, std::size_t station) const {
    if (stations_[station].motion.way != StationWay::Deposition) return true;
    const std::vector<JointRange>& ranges = solver_.ranges();
    for (std::size_t j = 0; j < ranges.size(); ++j) {
      const auto index = static_cast<Eigen::Index>(j);
      const double step = stepBetween(ranges[j], from[index], to[index]);
      if (ranges[j].is_rotary && std::abs(step) > toRadians(settings_.max_turn_deg)) return false;
    }
    return true;
  }

  std::vector<StationJoints>& joints_;
  const std::vector<Station>& stations_;
  const RungSolver& solver_;
  const JointPathSettings& settings_;
};

/// A run of stations.
struct Run {
  std::size_t begin = 0;
  std::size_t end = 0;
};

}  // namespace

void smoothSamples(std::vector<StationJoints>& joints, const StationTask& task, Progress& progress) {
  SampleSmoothing smoothing(joints, task);
  std::vector<Run> runs;
  for (std::size_t begin = 0; begin < joints.size();) {
    const std::size_t end = smoothing.runEnd(begin);
    if (joints[begin].node != kNoNode && joints[begin].kind != SampleKind::Single && end - begin > 2)
      runs.push_back({begin, end});
    begin = end;
  }
  // The ends of a run keep their values, so that runs do not meet each other's changes.
  parallelFor(
      runs.size(), [&](std::size_t r) { smoothing.smooth(runs[r].begin, runs[r].end); }, progress, "joints");
}

}  // namespace lamina
