// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <urdf_model/model.h>

#include <memory>
#include <string>

#include "kinematics/arm/arm_chain.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// An arm of rotary joints, alone or with external axes; the inverse kinematics depend on the number of
/// joints.
class ArmModel : public KinematicModel {
 public:
  explicit ArmModel(ArmChain chain) : chain_(std::move(chain)) {}

  const std::string& name() const override { return chain_.whole.name; }
  const std::string& urdf() const override { return chain_.whole.urdf; }
  const std::vector<DrivenJoint>& joints() const override { return chain_.whole.joints; }
  ToolAxisSpin toolAxisSpin() const override { return ToolAxisSpin::Given; }

  Eigen::Isometry3d bedFromNozzle(const JointValues& values) const override;
  Jacobian jacobian(const JointValues& values) const override;
  std::map<std::string, Eigen::Isometry3d> bedFromLinks(const JointValues& values) const override;
  std::map<std::string, double> urdfJoints(const JointValues& values) const override;

  const ArmChain& chain() const { return chain_; }
  /// Kinematic class, which determines the solver of the inverse kinematics.
  virtual std::string kinematicClass() const = 0;

 private:
  ArmChain chain_;
};

/// The kinematic model as an arm.
/// @throws InvalidConfig naming the model if it is no arm
const ArmModel& requireArm(const KinematicModel& model);

/// Makes the kinematic model of an arm of five to seven axes from its URDF.
/// @throws InvalidConfig as `serialChain` and `armChain`, and naming both axes if neighbouring axes of a
///   seven-axis arm are not at right angles
std::unique_ptr<KinematicModel> armModel(const urdf::ModelInterface& model, const std::string& text);

}  // namespace lamina
