// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <boost/container/static_vector.hpp>
#include <memory>
#include <string>

#include "kinematics/arm/arm_chain.hpp"

namespace lamina {

/// Greatest number of solutions that an arm of six joints has for one pose.
inline constexpr std::size_t kMostArmSolutions = 16;

/// One solution of the inverse kinematics. `branch` holds the signs of its configuration as bits: 4 if the
/// wrist is behind axis 1, 2 if the wrist is behind the upper arm, 1 if axis 5 is negative, counted from
/// where axes 4 and 6 are in line. This number is the cfx of the controllers. If a pose has several solutions
/// with the same signs, 8, 16, ... are added to those after the first, in the order of joint 6.
struct ArmSolution {
  int branch = 0;
  ArmValues values;  ///< in (-pi, pi]
};
using ArmSolutions = boost::container::static_vector<ArmSolution, kMostArmSolutions>;

/// Signed sines that vanish at an arm's singularities.
struct ArmSines {
  /// Sine of the wrist's angle from axis 1, as in `shoulderSine`; positive to the front.
  double shoulder = 1.0;
  double elbow = 1.0;  ///< sine of the angle from the upper arm to the forearm; positive to the front
  double wrist = 1.0;  ///< sine of the angle from axis 4 to axis 6, about axis 5
};

int branchOf(const ArmSines& sines);

/// Inverse kinematics of an arm of six rotary joints. Objects are immutable.
class ArmInverse {
 public:
  virtual ~ArmInverse() = default;
  /// All solutions for a pose, one for each branch, in the order of branches.
  virtual ArmSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle, const ArmValues& near) const = 0;
  virtual ArmSines sines(const ArmValues& values) const = 0;
  /// As `KinematicModel::singularityMargin`.
  virtual double singularityMargin(const ArmValues& values) const = 0;
};

/// Inverse kinematics in closed form of an arm with a spherical wrist (`sphericalWristArm`); null for any
/// other arm.
std::unique_ptr<const ArmInverse> closedFormInverse(const SerialChain& arm);

/// Inverse kinematics in closed form of an arm whose axes 2, 3 and 4 are parallel and at a right angle to
/// axis 1, and whose axes 5 and 6 meet within 0.5 mm; null for any other arm.
std::unique_ptr<const ArmInverse> parallelAxesInverse(const SerialChain& arm);

/// Inverse kinematics, by a search along joint 6, of an arm whose axes 4 and 5 meet within 0.5 mm, with axis
/// 2 at a right angle to axis 1, and axis 3 parallel to axis 2; null for any other arm.
std::unique_ptr<const ArmInverse> offsetWristInverse(const SerialChain& arm);

/// Inverse kinematics of an arm of any geometry, by iteration from several starts. A call takes milliseconds
/// and may miss a branch.
std::unique_ptr<const ArmInverse> iteratedInverse(const SerialChain& arm);

/// The inverse kinematics of the first of these classes to which an arm belongs, and the name of the class.
struct ClassifiedInverse {
  std::unique_ptr<const ArmInverse> inverse;
  std::string name;
};
ClassifiedInverse classifiedInverse(const SerialChain& arm);

}  // namespace lamina
