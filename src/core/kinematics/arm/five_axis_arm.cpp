// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/arm/five_axis_arm.hpp"

#include <cmath>
#include <utility>

#include "kinematics/arm/arm_axes.hpp"

namespace lamina {
namespace {

constexpr double kMostTilt = 1e-5;  // rad: out of the plane of an arm; a tip 300 mm on is 3 um aside

using FiveValues = Eigen::Matrix<double, 5, 1>;

/// The tool axis with all joints at zero.
Screw toolAxisAtZero(const SerialChain& arm) {
  const Eigen::Isometry3d& nozzle = arm.bed_from_nozzle_at_zero;
  return {nozzle.linear().col(2), nozzle.translation()};
}

/// About which the missing joint between joints 4 and 5 would turn.
Screw tiltingAxis(const SerialChain& arm) {
  const Screw& fourth = arm.screws[3];
  const Screw& fifth = arm.screws[4];
  if (areParallel(fourth, fifth)) return {fourth.direction.unitOrthogonal(), fourth.point};
  return {fourth.direction.cross(fifth.direction).normalized(), nearest(fifth, fourth)};
}

Eigen::Index missingJoint(const SerialChain& arm) {
  return areParallel(toolAxisAtZero(arm), arm.screws[4]) ? 4 : 5;
}

/// The chain of six joints, the missing one among them.
SerialChain sixOf(const SerialChain& arm) {
  SerialChain six = arm;
  const Eigen::Index missing = missingJoint(arm);
  const Screw axis = missing == 5 ? toolAxisAtZero(arm) : tiltingAxis(arm);
  six.screws.insert(six.screws.begin() + missing, axis);
  six.joints.insert(six.joints.begin() + missing, {"missing", JointKind::Rotary, -M_PI, M_PI, 1.0});
  six.outward.push_back(5);
  return six;
}

}  // namespace

FiveAxisArm::FiveAxisArm(ArmChain chain)
    : ArmModel(std::move(chain)),
      missing_(missingJoint(this->chain().arm)),
      inverse_(classifiedInverse(sixOf(this->chain().arm))) {}

std::string FiveAxisArm::kinematicClass() const {
  const std::string rest = ", solved as six with " + inverse_.name;
  return missing_ == kLast ? "five axes, tool axis aside of axis 5" + rest
                           : "five axes, tool axis along axis 5" + rest;
}

/// The six values, the missing joint at zero.
ArmValues FiveAxisArm::withMissing(const JointValues& values) const {
  const auto five = armValues<FiveValues>(chain(), values);
  ArmValues six;
  for (Eigen::Index j = 0; j < six.size(); ++j) six[j] = j == missing_ ? 0.0 : five[j < missing_ ? j : j - 1];
  return six;
}

InverseSolutions FiveAxisArm::solutions(const Eigen::Isometry3d& bed_from_nozzle,
                                        const JointValues& near) const {
  const Eigen::Isometry3d wanted = withoutExternal(chain(), bed_from_nozzle, near);
  InverseSolutions found;
  for (const ArmSolution& six : inverse_.inverse->solutions(wanted, withMissing(near))) {
    if (missing_ != kLast && !(std::abs(six.values[missing_]) <= kMostTilt)) continue;
    FiveValues five;
    for (Eigen::Index j = 0; j < five.size(); ++j) five[j] = six.values[j < missing_ ? j : j + 1];
    found.push_back({six.branch, withArmValues(chain(), near, five)});
  }
  return found;
}

double FiveAxisArm::singularityMargin(const JointValues& values) const {
  return inverse_.inverse->singularityMargin(withMissing(values));
}

}  // namespace lamina
