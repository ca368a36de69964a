// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/arm/seven_axes.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/arm/arm_axes.hpp"
#include "kinematics/model/joint_ranges.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::size_t kElbow = 3;  // index of axis 4

/// The foot of the perpendicular from a point to an axis.
Point3 footOn(const Screw& axis, const Point3& point) {
  return axis.point + axis.direction.dot(point - axis.point) * axis.direction;
}

/// The point about which an axis of shoulder or wrist should turn.
const Point3& centreOf(const SevenAxes& arm, std::size_t axis) {
  return axis < kElbow ? arm.shoulder : arm.wrist;
}

/// What the arm angle is made of: the line from the shoulder to the wrist, and the direction at a right angle
/// to it and to axis 1, not normalised.
struct AngleFrame {
  Point3 line;
  Point3 along;
  Point3 level;
  Point3 elbow;  ///< direction of axis 4
};

AngleFrame angleFrameOf(const SevenAxes& arm, const SevenPosture& posture) {
  AngleFrame frame;
  frame.line = posture.wrist - arm.shoulder;
  frame.along = frame.line.normalized();
  frame.level = arm.axes[0].direction.cross(frame.line);
  frame.elbow = arm.elbow_sense * posture.axes[kElbow].direction;
  return frame;
}

}  // namespace

SevenAxes sevenAxes(const SerialChain& arm) {
  SevenAxes seven;
  std::copy_n(arm.screws.begin(), seven.axes.size(), seven.axes.begin());
  for (std::size_t i = 0; i + 1 < seven.axes.size(); ++i) {
    if (areAtRightAngle(seven.axes[i], seven.axes[i + 1])) continue;
    const double cosine = seven.axes[i].direction.dot(seven.axes[i + 1].direction);
    throw InvalidConfig("arm '" + arm.name + "' has seven axes, and those of joints '" + arm.joints[i].name +
                        "' and '" + arm.joints[i + 1].name + "' are at " +
                        angleText(std::acos(std::clamp(cosine, -1.0, 1.0))) +
                        "; expected 90 deg between neighbouring axes");
  }
  seven.bed_from_nozzle_at_zero = arm.bed_from_nozzle_at_zero;
  seven.shoulder = nearest(seven.axes[0], seven.axes[1]);
  seven.wrist = nearest(seven.axes[5], seven.axes[4]);
  for (std::size_t i = 0; i < seven.axes.size(); ++i)
    seven.axes[i].point = footOn(seven.axes[i], centreOf(seven, i));
  seven.elbow_sense = seven.axes[1].direction.dot(seven.axes[kElbow].direction) < -0.5 ? -1.0 : 1.0;
  return seven;
}

double offsetOf(const SevenAxes& arm) {
  double offset = 0.0;
  for (std::size_t i = 0; i < arm.axes.size(); ++i)
    if (i != kElbow) offset = std::max(offset, (arm.axes[i].point - centreOf(arm, i)).norm());
  return offset;
}

double tiltOf(const SevenAxes& arm) {
  double tilt = 0.0;
  for (std::size_t i = 0; i + 1 < arm.axes.size(); ++i)
    tilt = std::max(tilt, std::abs(arm.axes[i].direction.dot(arm.axes[i + 1].direction)));
  return std::asin(std::min(1.0, tilt));
}

SevenAxes movedAxes(const SevenAxes& arm, double part) {
  SevenAxes moved = arm;
  for (std::size_t i = 0; i < moved.axes.size(); ++i)
    if (i != kElbow) moved.axes[i].point = centreOf(arm, i) + part * (arm.axes[i].point - centreOf(arm, i));
  return moved;
}

SevenPosture postureOf(const SevenAxes& arm, const SevenValues& values) {
  SevenPosture posture;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Point3 shift = Point3::Zero();
  for (std::size_t i = 0; i < arm.axes.size(); ++i) {
    const Screw& axis = arm.axes[i];
    if (i == 5) posture.wrist = turn * arm.wrist + shift;
    posture.axes[i] = {turn * axis.direction, turn * axis.point + shift};
    turn = turn * matrixOf(axis.direction, turnOf(values[static_cast<Eigen::Index>(i)]));
    shift = posture.axes[i].point - turn * axis.point;
  }
  posture.bed_from_nozzle.linear() = turn * arm.bed_from_nozzle_at_zero.linear();
  posture.bed_from_nozzle.translation() = turn * arm.bed_from_nozzle_at_zero.translation() + shift;
  return posture;
}

double armAngle(const SevenAxes& arm, const SevenPosture& posture) {
  const AngleFrame frame = angleFrameOf(arm, posture);
  const double angle =
      std::atan2(frame.along.dot(frame.level.cross(frame.elbow)), frame.level.dot(frame.elbow));
  return angle <= -M_PI ? M_PI : angle;
}

Eigen::Matrix<double, 1, 7> armAngleRates(const SevenAxes& arm, const SevenPosture& posture) {
  const AngleFrame frame = angleFrameOf(arm, posture);
  const double x = frame.level.dot(frame.elbow);
  const double y = frame.along.dot(frame.level.cross(frame.elbow));
  const double square = x * x + y * y;
  Eigen::Matrix<double, 1, 7> rates = Eigen::Matrix<double, 1, 7>::Zero();
  for (std::size_t i = 0; i < 5; ++i) {
    const Screw& axis = posture.axes[i];
    const Point3 line = axis.direction.cross(posture.wrist - axis.point);
    const Point3 elbow = i < kElbow ? Point3(axis.direction.cross(frame.elbow)) : Point3::Zero();
    const Point3 level = arm.axes[0].direction.cross(line);
    const Point3 along = (line - frame.along.dot(line) * frame.along) / frame.line.norm();
    const double dx = level.dot(frame.elbow) + frame.level.dot(elbow);
    const double dy = along.dot(frame.level.cross(frame.elbow)) +
                      frame.along.dot(level.cross(frame.elbow) + frame.level.cross(elbow));
    rates[static_cast<Eigen::Index>(i)] = (x * dy - y * dx) / square;
  }
  return rates;
}

SevenSines sinesOf(const SevenAxes& arm, const SevenPosture& posture) {
  const auto& axes = posture.axes;
  const Screw& elbow = axes[kElbow];
  const auto across = [&](const Point3& vector) {
    return Point3(vector - elbow.direction.dot(vector) * elbow.direction);
  };
  const Point3 before = across(elbow.point - arm.shoulder);
  const Point3 after = across(posture.wrist - elbow.point);
  const Point3 line = (posture.wrist - arm.shoulder).normalized();
  const double size = before.norm() * after.norm();
  SevenSines sines;
  sines.shoulder = axes[0].direction.cross(axes[2].direction).dot(axes[1].direction);
  sines.elbow = size > 0.0 ? arm.elbow_sense * elbow.direction.dot(before.cross(after)) / size : 0.0;
  sines.wrist = axes[4].direction.cross(axes[6].direction).dot(axes[5].direction);
  sines.plane = axes[0].direction.cross(line).norm();
  return sines;
}

}  // namespace lamina
