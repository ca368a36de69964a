// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/arm/arm_axes.hpp"

#include <cmath>

namespace lamina {
namespace {

constexpr double kSameDirection = 1e-3;  // rad: more than the rounding of any description

double elbowSine(const ArmAxes& axes) {
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

ArmAxes axesAtZero(const SerialChain& arm) {
  ArmAxes axes;
  std::copy_n(arm.screws.begin(), axes.size(), axes.begin());
  return axes;
}

ArmAxes axesAt(const SerialChain& arm, const ArmValues& values) {
  ArmAxes axes;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Point3 shift = Point3::Zero();
  for (std::size_t j = 0; j < axes.size(); ++j) {
    const Screw& screw = arm.screws[j];
    axes[j] = {turn * screw.direction, turn * screw.point + shift};
    turn = turn * matrixOf(screw.direction, turnOf(values[static_cast<Eigen::Index>(j)]));
    shift = axes[j].point - turn * screw.point;
  }
  return axes;
}

bool areParallel(const Screw& a, const Screw& b) {
  return a.direction.cross(b.direction).norm() < kSameDirection;
}

bool areAtRightAngle(const Screw& a, const Screw& b) {
  return std::abs(a.direction.dot(b.direction)) < kSameDirection;
}

Point3 nearest(const Screw& on, const Screw& to) {
  const Point3 common = on.direction.cross(to.direction);
  const double along = (to.point - on.point).cross(to.direction).dot(common) / common.squaredNorm();
  return on.point + along * on.direction;
}

double gapBetween(const Screw& a, const Screw& b) { return (nearest(a, b) - nearest(b, a)).norm(); }

double shoulderSine(const ArmAxes& axes, const Point3& wrist) {
  if (areParallel(axes[0], axes[1])) return 1.0;
  const Point3& up = axes[0].direction;
  const double height = up.dot(wrist - axes[1].point);
  const double front = axes[1].direction.cross(up).normalized().dot(wrist - axes[0].point);
  const double distance = std::hypot(front, height);
  return distance > 0.0 ? front / distance : 0.0;
}

ArmSines generalSines(const ArmAxes& axes) {
  ArmSines sines;
  sines.shoulder =
      shoulderSine(axes, areParallel(axes[4], axes[5]) ? axes[4].point : nearest(axes[4], axes[5]));
  sines.elbow = elbowSine(axes);
  sines.wrist = axes[3].direction.cross(axes[5].direction).dot(axes[4].direction);
  return sines;
}

ArmPlane::ArmPlane(const ArmAxes& axes, const Point3& end)
    : centre_(axes[0].point), axis_(axes[0].direction), normal_(axes[1].direction) {
  u_ = normal_.unitOrthogonal();
  v_ = normal_.cross(u_);
  shoulder_ = axes[1].point;
  const Point2 upper = inPlane(axes[2].point - shoulder_);
  const Point2 fore = inPlane(end - axes[2].point);
  upper_mm_ = upper.norm();
  fore_mm_ = fore.norm();
  upper_at_zero_ = upper / upper_mm_;
  bent_at_zero_ = difference(fore / fore_mm_, upper_at_zero_);
  sense_ = axes[2].direction.dot(normal_) > 0.0 ? 1.0 : -1.0;
}

TwoTurns ArmPlane::firstTurns(const Point3& point, const Point3& at_zero) const {
  const Point3 from_axis = point - centre_;
  return turnsWith(from_axis.dot(normal_), from_axis.dot(axis_.cross(normal_)),
                   normal_.dot(at_zero - centre_));
}

Point3 ArmPlane::turnedBack(const Point3& point, const Turn& first) const {
  return centre_ + turned(point - centre_, axis_, {first.x(), -first.y()});
}

ArmPlane::Ways ArmPlane::waysTo(const Point3& point) const {
  const Point2 target = inPlane(point - shoulder_);
  const double upper = upper_mm_;
  const double fore = fore_mm_;
  const double wanted = (target.squaredNorm() - upper * upper - fore * fore) / (2.0 * upper * fore);
  const double cosine = std::clamp(wanted, -1.0, 1.0);
  const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
  Ways ways;
  ways.excess = std::abs(wanted) - 1.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Turn bent(cosine, i == 0 ? sine : -sine);
    const Point2 stretched(upper + fore * bent.x(), fore * bent.y());
    const Turn along = difference(target, stretched);
    const double size = along.norm();
    const Turn upper_turn = size > 0.0 ? difference(along / size, upper_at_zero_) : Turn(1.0, 0.0);
    ways.ways[i] = {upper_turn, difference(bent, bent_at_zero_)};
  }
  return ways;
}

}  // namespace lamina
