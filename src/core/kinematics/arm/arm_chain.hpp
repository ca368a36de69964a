// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "kinematics/model/serial_chain.hpp"

namespace lamina {

/// Values of an arm's joints from the base to the nozzle [rad].
using ArmValues = Eigen::Matrix<double, 6, 1>;

/// A chain split into external axes, next to the bed, and the six joints of an arm, next to the nozzle.
struct ArmChain {
  SerialChain whole;
  SerialChain external;  ///< the external axes alone; the chain ends after the last of them
  SerialChain arm;       ///< the six joints alone, from the base to the nozzle; external axes at zero
  /// Index of each external joint among the joints of the whole chain.
  std::vector<Eigen::Index> external_index;
  std::array<Eigen::Index, 6> arm_index{};
};

/// Splits a chain.
/// @throws InvalidConfig stating the joints found, unless six rotary joints are next to the nozzle and all
///   others are named external_...
ArmChain armChain(SerialChain whole);

ArmValues armValues(const ArmChain& chain, const JointValues& values);

/// Joint values of the whole chain with those of the arm's joints replaced.
JointValues withArmValues(const ArmChain& chain, JointValues values, const ArmValues& arm);

/// A pose of the nozzle over the bed, converted to the bed as it stands with all external axes at zero.
Eigen::Isometry3d withoutExternal(const ArmChain& chain, const Eigen::Isometry3d& bed_from_nozzle,
                                  const JointValues& values);

}  // namespace lamina
