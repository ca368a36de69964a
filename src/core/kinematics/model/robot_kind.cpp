// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/robot_kind.hpp"

#include "kinematics/model/link_motion.hpp"

namespace lamina {

std::optional<std::string> robotKind(const urdf::ModelInterface& model) {
  if (model.getJoint(kAxisNames[0])) return std::nullopt;
  if (model.getJoint(kArmJoint)) return "arm";
  if (model.getJoint(kPlatformJoint)) return "platform";
  return std::nullopt;
}

}  // namespace lamina
