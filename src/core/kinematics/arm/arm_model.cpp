// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/arm/arm_model.hpp"

#include <utility>

#include "kinematics/arm/five_axis_arm.hpp"
#include "kinematics/arm/seven_axis_arm.hpp"
#include "kinematics/arm/six_axis_arm.hpp"
#include "lamina/base/error.hpp"

namespace lamina {

Eigen::Isometry3d ArmModel::bedFromNozzle(const JointValues& values) const {
  return lamina::bedFromNozzle(chain_.whole, values);
}

Jacobian ArmModel::jacobian(const JointValues& values) const {
  return lamina::jacobian(chain_.whole, values);
}

std::map<std::string, Eigen::Isometry3d> ArmModel::bedFromLinks(const JointValues& values) const {
  return lamina::bedFromLinks(chain_.whole, values);
}

std::map<std::string, double> ArmModel::urdfJoints(const JointValues& values) const {
  return lamina::urdfJoints(chain_.whole, values);
}

const ArmModel& requireArm(const KinematicModel& model) {
  const auto* arm = dynamic_cast<const ArmModel*>(&model);
  if (arm == nullptr)
    throw InvalidConfig("machine '" + model.name() + "' is no arm; expected one of five to seven axes");
  return *arm;
}

std::unique_ptr<KinematicModel> armModel(const urdf::ModelInterface& model, const std::string& text) {
  ArmChain chain = armChain(serialChain(model, text));
  if (chain.arm_index.size() == 7) return std::make_unique<SevenAxisArm>(std::move(chain));
  if (chain.arm_index.size() == 5) return std::make_unique<FiveAxisArm>(std::move(chain));
  return std::make_unique<SixAxisArm>(std::move(chain));
}

}  // namespace lamina
