// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/arm/arm_model.hpp"
#include "kinematics/arm/seven_axis_inverse.hpp"

namespace lamina {

/// An arm of seven rotary joints, alone or with external axes. Its redundancy is the arm angle.
class SevenAxisArm : public ArmModel, public Redundancy {
 public:
  /// @throws InvalidConfig naming both joints if neighbouring axes are not at right angles
  explicit SevenAxisArm(ArmChain chain);

  /// With the arm angle of `near`.
  InverseSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle,
                             const JointValues& near) const override;
  double singularityMargin(const JointValues& values) const override;
  std::string kinematicClass() const override;
  const Redundancy* redundancy() const override { return this; }

  double angleAt(const JointValues& values) const override;
  InverseSolutions solutionsWith(const Eigen::Isometry3d& bed_from_nozzle, const JointValues& near,
                                 double angle) const override;

 private:
  SevenAxisInverse inverse_;
};

}  // namespace lamina
