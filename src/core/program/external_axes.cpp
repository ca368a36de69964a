// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/external_axes.hpp"

#include "kinematics/model/external_joint.hpp"
#include "lamina/base/angle.hpp"

namespace lamina {

std::vector<double> externalAxes(const KinematicModel& arm, const JointValues& values) {
  std::vector<double> external;
  for (std::size_t j = 0; j < arm.joints().size(); ++j) {
    const double value = values[static_cast<Eigen::Index>(j)];
    if (isExternal(arm.joints()[j].name))
      external.push_back(arm.joints()[j].kind == JointKind::Linear ? value : value * kDegreesPerRadian);
  }
  return external;
}

std::vector<JointKind> externalAxisKinds(const KinematicModel& arm) {
  std::vector<JointKind> kinds;
  for (const DrivenJoint& joint : arm.joints())
    if (isExternal(joint.name)) kinds.push_back(joint.kind);
  return kinds;
}

std::optional<JointValues> withExternalAxes(const KinematicModel& arm, JointValues values,
                                            const std::vector<double>& external) {
  std::size_t next = 0;
  for (std::size_t j = 0; j < arm.joints().size(); ++j) {
    const DrivenJoint& joint = arm.joints()[j];
    if (!isExternal(joint.name)) continue;
    if (next == external.size()) return std::nullopt;
    const double value = external[next++];
    values[static_cast<Eigen::Index>(j)] = joint.kind == JointKind::Linear ? value : toRadians(value);
  }
  return values;
}

}  // namespace lamina
