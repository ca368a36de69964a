// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "kinematics/model/serial_chain.hpp"

namespace lamina {

/// Values of an arm's joints from the base to the nozzle [rad].
using ArmValues = Eigen::Matrix<double, 6, 1>;

/// A chain as external axes, next to the bed, and the six joints of an arm, next to the nozzle.
struct ArmChain {
  SerialChain whole;
  SerialChain external;  ///< the external axes alone; nothing beyond them
  SerialChain arm;       ///< the six joints alone, from the base to the nozzle; external axes at zero
  std::vector<Eigen::Index> external_index;  ///< of its joints in the whole
  std::array<Eigen::Index, 6> arm_index{};
};

/// @throws InvalidConfig unless there are six rotary joints next to the nozzle and all others are named
///   external_...; says what there is
ArmChain armChain(SerialChain whole);

ArmValues armValues(const ArmChain& chain, const JointValues& values);

/// Values with those of the arm's joints replaced.
JointValues withArmValues(const ArmChain& chain, JointValues values, const ArmValues& arm);

/// What external axes do to the bed: a pose of the nozzle over the bed, seen from where the bed is with them
/// at zero.
Eigen::Isometry3d withoutExternal(const ArmChain& chain, const Eigen::Isometry3d& bed_from_nozzle,
                                  const JointValues& values);

}  // namespace lamina
