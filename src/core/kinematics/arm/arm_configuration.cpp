// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/arm/arm_configuration.hpp"

#include <cmath>

namespace lamina {
namespace {

constexpr double kParallel = 1e-3;  // rad: more than the rounding of any description

using Axes = std::array<Screw, 6>;

Axes axesAt(const SerialChain& arm, const ArmValues& values) {
  Axes axes;
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  for (std::size_t j = 0; j < axes.size(); ++j) {
    const Screw& screw = arm.screws[j];
    axes[j] = {moved.linear() * screw.direction, moved * screw.point};
    moved = moved * Eigen::Translation3d(screw.point) *
            Eigen::AngleAxisd(values[static_cast<Eigen::Index>(j)], screw.direction) *
            Eigen::Translation3d(-screw.point);
  }
  return axes;
}

bool areParallel(const Screw& a, const Screw& b) { return a.direction.cross(b.direction).norm() < kParallel; }

/// The point of an axis nearest to another, which is no parallel.
Point3 nearest(const Screw& on, const Screw& to) {
  const Point3 common = on.direction.cross(to.direction);
  const double along = (to.point - on.point).cross(to.direction).dot(common) / common.squaredNorm();
  return on.point + along * on.direction;
}

double shoulderSine(const Axes& axes) {
  if (areParallel(axes[0], axes[1])) return 1.0;
  const Point3& up = axes[0].direction;
  const Point3 wrist = areParallel(axes[4], axes[5]) ? axes[4].point : nearest(axes[4], axes[5]);
  const Point3 from_base = wrist - axes[0].point;
  const double height = up.dot(wrist - axes[1].point);
  const double front = axes[1].direction.cross(up).normalized().dot(from_base);
  const double distance = std::hypot(front, height);
  return distance > 0.0 ? front / distance : 0.0;
}

double elbowSine(const Axes& axes) {
  if (!areParallel(axes[1], axes[2])) return 1.0;
  const Point3& axis = axes[1].direction;
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
  const bool goes_on = areParallel(axes[2], axes[3]) || areParallel(axes[3], axes[4]);
  const Point3 end = goes_on ? axes[3].point : nearest(axes[3], axes[4]);
  const Point3 upper = across * (axes[2].point - axes[1].point);
  const Point3 fore = across * (end - axes[2].point);
  const double size = upper.norm() * fore.norm();
  return size > 0.0 ? axis.dot(upper.cross(fore)) / size : 0.0;
}

}  // namespace

ArmSines generalSines(const SerialChain& arm, const ArmValues& values) {
  const Axes axes = axesAt(arm, values);
  ArmSines sines;
  sines.shoulder = shoulderSine(axes);
  sines.elbow = elbowSine(axes);
  sines.wrist = axes[3].direction.cross(axes[5].direction).dot(axes[4].direction);
  return sines;
}

}  // namespace lamina
