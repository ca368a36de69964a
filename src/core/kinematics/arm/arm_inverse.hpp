// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <boost/container/static_vector.hpp>
#include <memory>

#include "kinematics/arm/arm_chain.hpp"

namespace lamina {

/// Of one pose: what arms of six joints have at most.
inline constexpr std::size_t kMostArmSolutions = 16;

/// Signs of a configuration as bits: 4 wrist behind axis 1, 2 wrist behind the upper arm, 1 axis 5 negative,
/// counted from where axes 4 and 6 are in line. It is the controllers' cfx. Where a pose has several
/// solutions of the same signs, those after the first have 8, 16, ... more, by joint 6.
struct ArmSolution {
  int branch = 0;
  ArmValues values;  ///< in (-pi, pi]
};
using ArmSolutions = boost::container::static_vector<ArmSolution, kMostArmSolutions>;

/// What vanishes at an arm's singularities, signed.
struct ArmSines {
  double shoulder = 1.0;  ///< of the wrist off axis 1, seen from the height of axis 2; to the front
  double elbow = 1.0;     ///< of the forearm from the upper arm; to the front
  double wrist = 1.0;     ///< of axis 6 from axis 4, about axis 5
};

int branchOf(const ArmSines& sines);

/// Inverse kinematics of an arm of six rotary joints. Values that never change.
class ArmInverse {
 public:
  virtual ~ArmInverse() = default;
  /// One per branch, by branch.
  virtual ArmSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle, const ArmValues& near) const = 0;
  virtual ArmSines sines(const ArmValues& values) const = 0;
  /// As `KinematicModel::singularityMargin`.
  virtual double singularityMargin(const ArmValues& values) const = 0;
};

/// In closed form, if the wrist is spherical (`sphericalWristArm`); nothing if not.
std::unique_ptr<const ArmInverse> closedFormInverse(const SerialChain& arm);

/// In closed form, if axes 2, 3 and 4 are parallel and at a right angle to 1, and axes 5 and 6 meet within
/// 0.5 mm; nothing if not.
std::unique_ptr<const ArmInverse> parallelAxesInverse(const SerialChain& arm);

/// By a search along joint 6, if axes 4 and 5 meet within 0.5 mm, axis 2 is at a right angle to 1 and 3
/// parallel to 2; nothing if not.
std::unique_ptr<const ArmInverse> offsetWristInverse(const SerialChain& arm);

/// By iteration from several starts, for any geometry: it takes milliseconds and may miss a branch.
std::unique_ptr<const ArmInverse> iteratedInverse(const SerialChain& arm);

}  // namespace lamina
