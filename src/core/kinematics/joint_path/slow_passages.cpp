// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <sstream>

#include "kinematics/joint_path/station_joints.hpp"

#include "lamina/base/angle.hpp"

namespace lamina {

namespace {

/// The joint that needs longest for a step, and how long.
struct Slowest {
  std::size_t joint = 0;
  double turn = 0.0;
  double duration_s = 0.0;
};

Slowest slowest(const JointValues& from, const JointValues& to, const std::vector<JointRange>& ranges) {
  Slowest found;
  for (std::size_t j = 0; j < ranges.size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    const double turn = std::abs(to[index] - from[index]);
    const double duration_s = turn / ranges[j].max_speed;
    if (ranges[j].is_rotary && duration_s > found.duration_s) found = {j, turn, duration_s};
  }
  return found;
}

}  // namespace

std::vector<StationFault> slowPassages(const std::vector<StationJoints>& joints, const StationTask& task) {
  std::vector<StationFault> faults;
  const double near = std::sin(toRadians(task.settings.singular_margin_deg));
  for (std::size_t i = 1; i < joints.size(); ++i) {
    const StationMotion& motion = task.stations[i].motion;
    if (!joints[i].is_linked || motion.way != StationWay::Deposition || motion.length_mm <= kInPlace)
      continue;
    const Slowest slow = slowest(joints[i - 1].values, joints[i].values, task.solver.ranges());
    const double slowdown = slow.duration_s / motion.duration_s;
    if (slowdown <= task.settings.max_slowdown) continue;
    const double margin = std::min(task.model.singularityMargin(joints[i - 1].values),
                                   task.model.singularityMargin(joints[i].values));
    if (margin >= near) continue;
    std::ostringstream reason;
    reason.precision(4);
    reason << "joint " << task.model.joints()[slow.joint].name << " turns by "
           << jointValueText(task.solver.ranges()[slow.joint], slow.turn)
           << " beside a singularity, which takes " << slowdown
           << " times as long as the motion at its feed; at most " << task.settings.max_slowdown;
    faults.push_back({i, JointFault::Singular, reason.str()});
  }
  return faults;
}

}  // namespace lamina
