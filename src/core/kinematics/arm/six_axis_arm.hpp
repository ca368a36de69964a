// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/arm/arm_inverse.hpp"
#include "kinematics/arm/arm_model.hpp"

namespace lamina {

/// An arm of six rotary joints, alone or with external axes.
class SixAxisArm : public ArmModel {
 public:
  explicit SixAxisArm(ArmChain chain);

  InverseSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle,
                             const JointValues& near) const override;
  double singularityMargin(const JointValues& values) const override;
  std::string kinematicClass() const override { return inverse_.name; }

  ArmSines sines(const JointValues& values) const {
    return inverse_.inverse->sines(armValues(chain(), values));
  }

 private:
  ClassifiedInverse inverse_;
};

/// The kinematic model as a six-axis arm.
/// @throws InvalidConfig naming the model if it is no such arm
const SixAxisArm& requireSixAxisArm(const KinematicModel& model);

}  // namespace lamina
