// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/led_joints.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "kinematics/model/external_joint.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/kinematics/arm/configured_joints.hpp"

namespace lamina {
namespace {

constexpr double kLedStep = 10.0;            // mm
constexpr double kLedTurn = toRadians(5.0);  // of the nozzle

}  // namespace

std::optional<JointValues> ledJoints(const KinematicModel& arm, const JointValues& from,
                                     const Eigen::Isometry3d& bed_from_nozzle, const JointValues& to) {
  const Eigen::Isometry3d start = arm.bedFromNozzle(from);
  const Eigen::Quaterniond begin(start.linear());
  const Eigen::Quaterniond end(bed_from_nozzle.linear());
  const double way_mm = (bed_from_nozzle.translation() - start.translation()).norm();
  const int steps = std::max({1, static_cast<int>(std::ceil(way_mm / kLedStep)),
                              static_cast<int>(std::ceil(begin.angularDistance(end) / kLedTurn))});
  std::optional<JointValues> joints = from;
  for (int s = 1; s <= steps && joints; ++s) {
    const double fraction = static_cast<double>(s) / steps;
    JointValues near = *joints;
    for (std::size_t j = 0; j < arm.joints().size(); ++j) {
      const auto index = static_cast<Eigen::Index>(j);
      if (isExternal(arm.joints()[j].name)) near[index] = from[index] + fraction * (to[index] - from[index]);
    }
    Eigen::Isometry3d pose(begin.slerp(fraction, end));
    pose.translation() =
        start.translation() + fraction * (bed_from_nozzle.translation() - start.translation());
    joints = followingJoints(arm, s == steps ? bed_from_nozzle : pose, near);
  }
  return joints;
}

}  // namespace lamina
