// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/nozzle_motion.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr double kSameInstant = 1e-9;  // of a step

/// Direction of the motion to a waypoint; zero if it has no length.
Point3 directionTo(const Path& path, std::size_t waypoint) {
  const std::size_t from = waypoint > 0 ? waypoint - 1 : path.points.size() - 1;
  const Point3 way = path.points[waypoint] - path.points[from];
  return way.norm() > 0.0 ? Point3(way.normalized()) : Point3(Point3::Zero());
}

/// Of the motion to a waypoint at a speed of the tip; what is not deposited has no flow.
ProcessSignals signalsAt(const Path& path, std::size_t waypoint, double speed_mm_s) {
  ProcessSignals signals;
  if (path.role != PathRole::Travel) signals.flow_mm3_s = crossSection(path.bead.at(waypoint)) * speed_mm_s;
  signals.levels = levelsTo(path, waypoint);
  for (const ProcessLevel level : kAllProcessLevels)
    if (followsSpeed(level) && signals.levels.has(level))
      signals.levels[level] *= speed_mm_s / path.feed_mm_s.at(waypoint);
  return signals;
}

}  // namespace

NozzleState nozzleState(const JointState& joints, const KinematicModel& model) {
  const Eigen::Isometry3d pose = model.bedFromNozzle(joints.position);
  const Eigen::Matrix<double, 6, 1> twist = model.jacobian(joints.position) * joints.velocity;
  NozzleState state;
  state.time_s = joints.time_s;
  state.tip = pose.translation();
  state.orientation = Eigen::Quaterniond(pose.linear());
  state.velocity = twist.head<3>();
  state.turn = twist.tail<3>();
  state.process = joints.process;
  return state;
}

NozzleState nozzleState(const NozzleSample& sample, const Toolpath& toolpath,
                        const Eigen::Isometry3d& bed_from_part) {
  const WaypointIndex& to = sample.heading_for;
  const Path& path = toolpath.layers[to.layer].paths[to.path];
  NozzleState state;
  state.time_s = sample.time_s;
  state.tip = bed_from_part * sample.position;
  state.orientation = Eigen::Quaterniond(bed_from_part.linear()) * sample.orientation;
  state.velocity = sample.speed_mm_s * (bed_from_part.linear() * directionTo(path, to.waypoint));
  state.process = signalsAt(path, to.waypoint, sample.speed_mm_s);
  return state;
}

std::vector<double> evenTimes(double begin_s, double end_s, double step_s) {
  std::vector<double> times;
  const double steps = std::max(0.0, (end_s - begin_s) / step_s);
  const auto whole = static_cast<std::size_t>(std::ceil(steps - kSameInstant));
  times.reserve(whole + 1);
  for (std::size_t i = 0; i < whole; ++i) times.push_back(begin_s + static_cast<double>(i) * step_s);
  times.push_back(end_s);
  return times;
}

Eigen::Quaterniond alignedWith(const Eigen::Quaterniond& turn, const Eigen::Quaterniond& other) {
  return turn.dot(other) < 0.0 ? Eigen::Quaterniond(-turn.coeffs()) : turn;
}

}  // namespace lamina
