// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/container/static_vector.hpp>

#include "kinematics/model/serial_chain.hpp"

namespace lamina {

/// Values of the joints of a six-axis or a seven-axis arm, from the base to the nozzle [rad].
using ArmValues = Eigen::Matrix<double, 6, 1>;
using SevenValues = Eigen::Matrix<double, 7, 1>;

/// A chain split into external axes, next to the bed, and the joints of an arm, next to the nozzle.
struct ArmChain {
  SerialChain whole;
  SerialChain external;  ///< the external axes alone; the chain ends after the last of them
  SerialChain arm;       ///< the joints of the arm alone, from the base to the nozzle; external axes at zero
  /// Index of each external joint among the joints of the whole chain.
  std::vector<Eigen::Index> external_index;
  boost::container::static_vector<Eigen::Index, 7> arm_index;  ///< index of each joint of the arm, likewise
};

/// Splits a chain.
/// @throws InvalidConfig stating the joints found, unless five to seven rotary joints are next to the nozzle
///   and all other joints are named external_...
ArmChain armChain(SerialChain whole);

/// The values of the arm's joints among those of the whole chain.
template <class Values = ArmValues>
Values armValues(const ArmChain& chain, const JointValues& values) {
  Values arm;
  for (Eigen::Index j = 0; j < arm.size(); ++j) arm[j] = values[chain.arm_index[static_cast<std::size_t>(j)]];
  return arm;
}

/// Joint values of the whole chain with those of the arm's joints replaced.
template <class Values>
JointValues withArmValues(const ArmChain& chain, JointValues values, const Values& arm) {
  for (Eigen::Index j = 0; j < arm.size(); ++j) values[chain.arm_index[static_cast<std::size_t>(j)]] = arm[j];
  return values;
}

/// A pose of the nozzle over the bed, converted to the bed as it stands with all external axes at zero.
Eigen::Isometry3d withoutExternal(const ArmChain& chain, const Eigen::Isometry3d& bed_from_nozzle,
                                  const JointValues& values);

}  // namespace lamina
