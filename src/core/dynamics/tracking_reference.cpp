// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/dynamics/tracking_reference.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "geometry/space_vectors.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/platform/rus_workspace.hpp"
#include "lamina/toolpath/waypoint_text.hpp"
#include "toolpath/motion_cursor.hpp"

namespace lamina {
namespace {

/// Where a motion that ends at the waypoint stands among all; the return of a closed path is its last.
auto rankOf(const WaypointIndex& end) {
  const std::size_t last = std::numeric_limits<std::size_t>::max();
  return std::make_tuple(end.layer, end.path, end.waypoint == 0 ? last : end.waypoint);
}

Point3 rotationVector(const Eigen::Quaterniond& rotation) {
  const Eigen::AngleAxisd turn(rotation.w() < 0.0 ? Eigen::Quaterniond(-rotation.coeffs()) : rotation);
  return turn.angle() * turn.axis();
}

Eigen::Quaterniond turnedBy(const Point3& turn, const Eigen::Quaterniond& held) {
  return Eigen::Quaterniond(turnBy(turn)) * held;
}

CrankAngles twistOf(const Point3& velocity, const Point3& turn) {
  CrankAngles twist;
  twist << velocity, turn;
  return twist;
}

}  // namespace

ToolpathReference::ToolpathReference(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                                     const MotionLimits& limits, RusDescription description)
    : player_(toolpath, limits),
      description_(std::move(description)),
      base_from_part_(description_.base_from_bed * bed_from_part) {
  MotionCursor cursor(toolpath);
  while (cursor.step()) {
    const AlongPath<Eigen::Quaterniond>& along = cursor.path().orientation;
    const Eigen::Quaterniond from = motions_.empty()
                                        ? along.at(cursor.startWaypoint())
                                        : turnedBy(motions_.back().turn, motions_.back().held).normalized();
    const WaypointIndex end = cursor.endWaypoint();
    if (motions_.empty())
      requireWithin({end.layer, end.path, cursor.startWaypoint()}, poseOf(cursor.start(), from));
    const Eigen::Quaterniond& to = along.at(end.waypoint);
    requireWithin(end, poseOf(cursor.end(), to));
    motions_.push_back({end, cursor.start(), cursor.length(), from, rotationVector(to * from.conjugate())});
  }
}

const ToolpathReference::Motion& ToolpathReference::motionTo(const WaypointIndex& end) const {
  return *std::lower_bound(
      motions_.begin(), motions_.end(), end,
      [](const Motion& motion, const WaypointIndex& at) { return rankOf(motion.end) < rankOf(at); });
}

Eigen::Isometry3d ToolpathReference::poseOf(const Point3& tip, const Eigen::Quaterniond& held) const {
  const Eigen::Isometry3d part_from_nozzle = Eigen::Translation3d(tip) * held;
  return base_from_part_ * part_from_nozzle * description_.platform_from_nozzle.inverse();
}

void ToolpathReference::requireWithin(const WaypointIndex& at, const Eigen::Isometry3d& pose) const {
  const std::vector<FaultyLeg> faults = faultyLegs(description_.platform, pose);
  if (faults.empty()) return;
  std::string reasons;
  for (const FaultyLeg& fault : faults) reasons += (reasons.empty() ? "" : "; ") + fault.reason;
  throw Unreachable(toText(at) + ": " + reasons);
}

ReferenceState ToolpathReference::at(double time_s) const {
  const RestToRestSample sample = player_.at(time_s);
  const Motion& motion = motionTo(sample.heading_for);
  const double gone = (sample.position - motion.start).norm() / motion.length_mm;
  const Point3 turning = sample.velocity.norm() / motion.length_mm * motion.turn;
  ReferenceState state;
  state.pose = poseOf(sample.position, turnedBy(gone * motion.turn, motion.held));
  state.cranks = crankAngles(description_.platform, state.pose);

  const Eigen::Matrix3d base_from_part = base_from_part_.linear();
  const Point3 from_tip = state.pose.translation() - base_from_part_ * sample.position;
  const Point3 turn = base_from_part * turning;
  const CrankAngles twist = twistOf(base_from_part * sample.velocity + turn.cross(from_tip), turn);
  const VelocityEquation equation = velocityEquation(description_.platform, state.pose, state.cranks);
  state.rates = (equation.pose_rates * twist).cwiseQuotient(equation.crank_rates);
  return state;
}

TrajectoryReference::TrajectoryReference(const JointTrajectory& trajectory, RusPlatform platform)
    : trajectory_(trajectory), platform_(std::move(platform)) {
  const Eigen::Index joints = trajectory.at(0.0).position.size();
  if (joints != 6)
    throw InvalidInput("the trajectory moves " + std::to_string(joints) +
                       " joints; the platform has 6 cranks");
}

ReferenceState TrajectoryReference::at(double time_s) const {
  const JointState joints = trajectory_.at(time_s);
  return {joints.position, joints.velocity, poseFromHome(platform_, joints.position)};
}

}  // namespace lamina
