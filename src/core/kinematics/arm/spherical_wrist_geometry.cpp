// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "base/dense_solvers.hpp"
#include "kinematics/arm/spherical_wrist_arm.hpp"

namespace lamina {
namespace {

constexpr double kTilt = 1e-3;     // rad: more than the rounding of any description
constexpr double kOffset = 0.1;    // mm: the same
constexpr double kShortest = 1.0;  // mm: of an arm that is one

using WristAxes = std::array<Screw, 6>;

/// How far from a right angle [rad].
double fromRightAngle(const Point3& a, const Point3& b) {
  return std::asin(std::min(1.0, std::abs(a.dot(b))));
}

double fromParallel(const Point3& a, const Point3& b) { return std::asin(std::min(1.0, a.cross(b).norm())); }

double distanceTo(const Screw& axis, const Point3& point) {
  return axis.direction.cross(point - axis.point).norm();
}

/// The point nearest to axes 4, 5 and 6.
Point3 wristOf(const WristAxes& axes) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Point3 right = Point3::Zero();
  for (std::size_t i = 3; i < 6; ++i) {
    const Point3& direction = axes[i].direction;
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - direction * direction.transpose();
    sum += across;
    right += across * axes[i].point;
  }
  return symmetricSolution(sum, right);
}

/// The direction nearest to `wanted` at a right angle to `axis`.
Point3 across(const Point3& wanted, const Point3& axis) {
  return (wanted - axis.dot(wanted) * axis).normalized();
}

/// Tilt of the axes from the angles they should have [rad].
double tilt(const WristAxes& axes) {
  return std::max({fromRightAngle(axes[0].direction, axes[1].direction),
                   fromParallel(axes[1].direction, axes[2].direction),
                   fromRightAngle(axes[3].direction, axes[4].direction),
                   fromRightAngle(axes[4].direction, axes[5].direction)});
}

/// Distance of axes 4, 5 and 6 from the wrist [mm].
double offset(const WristAxes& axes, const Point3& wrist) {
  return std::max({distanceTo(axes[3], wrist), distanceTo(axes[4], wrist), distanceTo(axes[5], wrist)});
}

Eigen::Matrix3d columns(const Point3& y, const Point3& z) {
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  return axes;
}

Eigen::Isometry3d pose(const Eigen::Matrix3d& axes, const Point3& origin) {
  Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
  placed.linear() = axes;
  placed.translation() = origin;
  return placed;
}

/// The base: on axis 1 at the height of axis 2, x to the front.
Eigen::Isometry3d bedFromBase(const WristAxes& axes, const Point3& wrist) {
  const Point3 z = axes[0].direction;
  const Point3 origin = axes[0].point + z.dot(axes[1].point - axes[0].point) * z;
  Point3 y = across(axes[1].direction, z);
  const Point3 x = y.cross(z);
  const double shoulder = x.dot(axes[1].point - origin);
  const double front = std::abs(shoulder) > kOffset ? shoulder : x.dot(wrist - origin);
  if (front < -kOffset) y = -y;
  return pose(columns(y, z), origin);
}

/// Angle in the arm's plane from z to x.
double planeAngle(const Point3& direction) { return std::atan2(direction.x(), direction.z()); }

Eigen::Matrix3d aboutY(double angle) { return Eigen::AngleAxisd(angle, Point3::UnitY()).toRotationMatrix(); }

void setPlane(SphericalWristArm& arm, const WristAxes& axes, const Point3& wrist_in_bed) {
  const Point3 shoulder = arm.base_from_bed * axes[1].point;
  const Point3 elbow = arm.base_from_bed * axes[2].point;
  const Point3 wrist = arm.base_from_bed * wrist_in_bed;
  arm.shoulder_mm = shoulder.x();
  arm.side_mm = wrist.y();
  const Point3 upper = elbow - Point3(shoulder.x(), 0.0, 0.0);
  const Point3 fore = wrist - elbow;
  arm.upper_mm = std::hypot(upper.x(), upper.z());
  arm.fore_mm = std::hypot(fore.x(), fore.z());
  arm.zero[1] = planeAngle(upper);
  arm.zero[2] = std::remainder(planeAngle(fore) - planeAngle(upper), 2.0 * M_PI);
  for (const int axis : {1, 2}) {
    const Point3 direction = arm.base_from_bed.linear() * axes[static_cast<std::size_t>(axis)].direction;
    arm.sense[axis] = direction.y() > 0.0 ? 1.0 : -1.0;
  }
}

void setWrist(SphericalWristArm& arm, const WristAxes& axes, const Point3& wrist_in_bed) {
  const Point3& fourth = axes[3].direction;
  const Eigen::Matrix3d bed_from_wrist4 = columns(across(axes[4].direction, fourth), fourth);
  const Point3 sixth = bed_from_wrist4.transpose() * axes[5].direction;
  arm.zero[4] = std::atan2(sixth.x(), sixth.z());
  const Eigen::Matrix3d base_from_fore = aboutY(arm.zero[1] + arm.zero[2]);
  arm.fore_from_wrist4 = base_from_fore.transpose() * arm.base_from_bed.linear() * bed_from_wrist4;
  const Eigen::Matrix3d bed_from_wrist = bed_from_wrist4 * aboutY(arm.zero[4]);
  arm.nozzle_from_wrist = arm.nozzle_from_wrist * pose(bed_from_wrist, wrist_in_bed);
}

}  // namespace

std::optional<SphericalWristArm> sphericalWristArm(const WristAxes& axes,
                                                   const Eigen::Isometry3d& bed_from_nozzle_at_zero) {
  const Point3 wrist = wristOf(axes);
  const double off = offset(axes, wrist);
  const double tilted = tilt(axes);
  if (!(tilted <= kTilt) || !(off <= kOffset)) return std::nullopt;
  SphericalWristArm arm;
  arm.base_from_bed = bedFromBase(axes, wrist).inverse();
  arm.nozzle_from_wrist = bed_from_nozzle_at_zero.inverse();
  setPlane(arm, axes, wrist);
  setWrist(arm, axes, wrist);
  arm.deviation = std::max(tilted, off);
  if (arm.upper_mm < kShortest || arm.fore_mm < kShortest) return std::nullopt;
  return arm;
}

}  // namespace lamina
