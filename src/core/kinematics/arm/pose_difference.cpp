// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/arm/pose_difference.hpp"

#include <cmath>

#include "lamina/geometry/vector.hpp"

namespace lamina {

Eigen::Matrix<double, 6, 1> poseDifference(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  // The angle of a rotation matrix by its quaternion: exact where it is small.
  const Eigen::Quaterniond turn(to.linear() * from.linear().transpose());
  const double sign = turn.w() < 0.0 ? -1.0 : 1.0;
  const double sine = turn.vec().norm();
  const double angle = 2.0 * std::atan2(sine, std::abs(turn.w()));
  Eigen::Matrix<double, 6, 1> twist;
  twist.head<3>() = to.translation() - from.translation();
  twist.tail<3>() = sine > 0.0 ? Point3(kTurnLever * sign * angle / sine * turn.vec()) : Point3::Zero();
  return twist;
}

}  // namespace lamina
