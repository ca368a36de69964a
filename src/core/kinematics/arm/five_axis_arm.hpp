// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "kinematics/arm/arm_inverse.hpp"
#include "kinematics/arm/arm_model.hpp"

namespace lamina {

/// An arm of five rotary joints, alone or with external axes. The solver treats it as a six-joint arm with
/// one fictitious joint.
///
/// If the tool axis is not along axis 5, the fictitious joint turns the nozzle about its tool axis. Its angle
/// is free: solutions have the tip and the tool axis of a pose. If the tool axis is along axis 5, as of a
/// nozzle below the flange, joint 5 turns the nozzle about it. The fictitious joint then tilts the nozzle out
/// of the plane of the arm. Only poses without that tilt have solutions, within 1e-5 rad, such as those with
/// a vertical tool axis.
class FiveAxisArm : public ArmModel {
 public:
  explicit FiveAxisArm(ArmChain chain);

  ToolAxisSpin toolAxisSpin() const override {
    return missing_ == kLast ? ToolAxisSpin::Free : ToolAxisSpin::Given;
  }
  InverseSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle,
                             const JointValues& near) const override;
  double singularityMargin(const JointValues& values) const override;
  std::string kinematicClass() const override;

 private:
  static constexpr Eigen::Index kLast = 5;

  ArmValues withMissing(const JointValues& values) const;

  Eigen::Index missing_ = kLast;  ///< index of the fictitious joint among the six
  ClassifiedInverse inverse_;
};

}  // namespace lamina
