// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/robot_kind.hpp"

#include "kinematics/model/link_motion.hpp"

namespace lamina {
namespace {

constexpr int kLeastArmJoints = 3;  // so that an arm of four joints is refused as an arm

int rotaryJointsToNozzle(const urdf::ModelInterface& model) {
  int count = 0;
  for (auto link = model.getLink("nozzle"); link && link->parent_joint;
       link = model.getLink(link->parent_joint->parent_link_name)) {
    const int type = link->parent_joint->type;
    if (type == urdf::Joint::REVOLUTE || type == urdf::Joint::CONTINUOUS) ++count;
  }
  return count;
}

}  // namespace

std::optional<std::string> robotKind(const urdf::ModelInterface& model) {
  if (model.getJoint(kAxisNames[0])) return std::nullopt;
  if (model.getJoint(kPlatformJoint)) return "platform";
  if (rotaryJointsToNozzle(model) >= kLeastArmJoints) return "arm";
  return std::nullopt;
}

}  // namespace lamina
