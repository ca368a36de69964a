// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <memory>
#include <string>

#include "kinematics/arm/arm_inverse.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// An arm of six rotary joints, alone or with external axes.
class SixAxisArm : public KinematicModel {
 public:
  explicit SixAxisArm(ArmChain chain);

  const std::string& name() const override { return chain_.whole.name; }
  const std::string& urdf() const override { return chain_.whole.urdf; }
  const std::vector<DrivenJoint>& joints() const override { return chain_.whole.joints; }
  ToolAxisSpin toolAxisSpin() const override { return ToolAxisSpin::Given; }

  Eigen::Isometry3d bedFromNozzle(const JointValues& values) const override;
  Jacobian jacobian(const JointValues& values) const override;
  InverseSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle,
                             const JointValues& near) const override;
  double singularityMargin(const JointValues& values) const override;
  std::map<std::string, Eigen::Isometry3d> bedFromLinks(const JointValues& values) const override;
  std::map<std::string, double> urdfJoints(const JointValues& values) const override;

  const ArmChain& chain() const { return chain_; }
  ArmSines sines(const JointValues& values) const { return inverse_->sines(armValues(chain_, values)); }

 private:
  ArmChain chain_;
  std::unique_ptr<const ArmInverse> inverse_;
};

/// The kinematic model as a six-axis arm.
/// @throws InvalidConfig naming the model if it is no such arm
const SixAxisArm& requireSixAxisArm(const KinematicModel& model);

/// Makes the kinematic model of a six-axis arm from its URDF.
/// @throws InvalidConfig as `serialChain` and `armChain`
std::unique_ptr<KinematicModel> sixAxisArm(const urdf::ModelInterface& model, const std::string& text);

}  // namespace lamina
