// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/robot/robot_angles.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/space_vectors.hpp"
#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

constexpr double kGimbal = 1e-6;      // cosine of y: nearer than the last decimal of any language
constexpr double kHalfTurn = 1e-12;   // of w: under what a double resolves of the axis
constexpr double kSmallTurn = 1e-12;  // of the vector part

}  // namespace

RobotAngles robotAngles(const Eigen::Quaterniond& turn, double near_x_deg) {
  const Eigen::Matrix3d r = turn.normalized().toRotationMatrix();
  const double cosine = std::hypot(r(0, 0), r(1, 0));
  RobotAngles angles;
  angles.y_deg = toDegrees(std::atan2(-r(2, 0), cosine));
  if (cosine < kGimbal) {
    // Only the difference of x and z at 90 deg, or their sum at -90 deg, turns anything.
    const double about = toDegrees(std::atan2(r(2, 0) < 0.0 ? r(0, 1) : -r(0, 1), r(1, 1)));
    angles.y_deg = r(2, 0) < 0.0 ? 90.0 : -90.0;
    angles.x_deg = wrappedDegrees(near_x_deg);
    angles.z_deg = wrappedDegrees(r(2, 0) < 0.0 ? near_x_deg - about : about - near_x_deg);
    return angles;
  }
  const double z = std::atan2(r(1, 0), r(0, 0));
  // From the other two columns as z has turned them: right also where the first says little of z.
  const double x = std::atan2(std::sin(z) * r(0, 2) - std::cos(z) * r(1, 2),
                              std::cos(z) * r(1, 1) - std::sin(z) * r(0, 1));
  angles.z_deg = wrappedDegrees(toDegrees(z));
  angles.x_deg = wrappedDegrees(toDegrees(x));
  return angles;
}

Eigen::Quaterniond rotationOfAngles(const RobotAngles& angles) {
  const Eigen::Quaterniond turn = Eigen::AngleAxisd(toRadians(angles.z_deg), Eigen::Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(toRadians(angles.y_deg), Eigen::Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(toRadians(angles.x_deg), Eigen::Vector3d::UnitX());
  return turn.normalized();
}

Eigen::Vector3d rotationVector(const Eigen::Quaterniond& turn) {
  Eigen::Quaterniond q = turn.normalized();
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  const double sine = q.vec().norm();
  if (sine < kSmallTurn) return Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = q.vec() / sine;
  if (q.w() < kHalfTurn) {
    const auto first =
        std::find_if(axis.data(), axis.data() + 3, [](double value) { return std::abs(value) > kHalfTurn; });
    if (first != axis.data() + 3 && *first < 0.0) axis = -axis;
  }
  return 2.0 * std::atan2(sine, q.w()) * axis;
}

Eigen::Quaterniond rotationOfVector(const Eigen::Vector3d& rotation_vector) {
  return Eigen::Quaterniond(turnBy(rotation_vector)).normalized();
}

}  // namespace lamina
