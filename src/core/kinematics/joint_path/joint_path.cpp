// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/joint_path/joint_path.hpp"

namespace lamina {

const char* toString(JointFault fault) {
  switch (fault) {
    case JointFault::OutOfReach:
      return "out_of_reach";
    case JointFault::OutOfLimits:
      return "out_of_limits";
    case JointFault::SelfCollision:
      return "self_collision";
    case JointFault::Singular:
      return "singular";
    case JointFault::Jump:
      return "jump";
    case JointFault::JointUnwinding:
      return "joint_unwinding";
    case JointFault::Configuration:
      return "configuration";
  }
  return "unknown";
}

}  // namespace lamina
