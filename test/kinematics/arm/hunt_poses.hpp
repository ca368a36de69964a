// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/base/random.hpp"
#include "lamina/kinematics/platform/rus_kinematics.hpp"

namespace lamina {

/// A pose of the Hunt platform's stated workspace: the tip of its nozzle, 50 mm below, 40 mm aside of home
/// and 20 mm up or down at most, tilted by 45 deg at most [mm, base frame].
inline Eigen::Isometry3d randomPose(Random& random) {
  const double way = random.uniform(-M_PI, M_PI);
  const Point3 about(std::cos(way), std::sin(way), 0.0);
  const Point3 tip(0, 0, -50);
  Eigen::Isometry3d pose = huntPlatform().home;
  pose.linear() = Eigen::AngleAxisd(random.uniform(0.0, M_PI / 4), about).toRotationMatrix();
  pose.translation() += tip - pose.linear() * tip;
  pose.translation() += Point3(random.uniform(-40, 40), random.uniform(-40, 40), random.uniform(-20, 20));
  return pose;
}

/// The pose moved by a twist of its origin: a motion, then a turn.
inline Eigen::Isometry3d carried(const Eigen::Isometry3d& pose, const CrankAngles& twist) {
  Eigen::Isometry3d moved = pose;
  const Point3 turn = twist.tail<3>();
  moved.translation() += twist.head<3>();
  if (turn.norm() > 0.0) moved.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * pose.linear();
  return moved;
}

}  // namespace lamina
