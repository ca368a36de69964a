// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/model/joint_limits.hpp"

#include <cmath>

#include "lamina/base/angle.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

/// As people read it: degrees for what turns.
std::string shown(JointKind kind, double value) {
  return std::to_string(kind == JointKind::Linear ? value : toDegrees(value));
}

}  // namespace

std::optional<std::string> limitFault(const JointValues& values, const KinematicModel& model) {
  for (std::size_t j = 0; j < model.joints().size(); ++j) {
    const DrivenJoint& joint = model.joints()[j];
    const double value = values[static_cast<Eigen::Index>(j)];
    if (value >= joint.low - kJointLimitSlack && value <= joint.high + kJointLimitSlack) continue;
    const std::string unit = joint.kind == JointKind::Linear ? " mm" : " deg";
    return "joint " + joint.name + " at " + shown(joint.kind, value) + unit + "; must be within " +
           shown(joint.kind, joint.low) + " to " + shown(joint.kind, joint.high) + unit;
  }
  return std::nullopt;
}

std::string boundsText(const DrivenJoint& joint, double is, double low, double high) {
  return "joint '" + joint.name + "' " + numberText(is) + ", expected " + numberText(low) + " to " +
         numberText(high);
}

}  // namespace lamina
