// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/arm/six_axis_arm.hpp"

#include "lamina/base/error.hpp"

namespace lamina {

SixAxisArm::SixAxisArm(ArmChain chain) : chain_(std::move(chain)), inverse_(closedFormInverse(chain_.arm)) {
  for (const auto& make : {&parallelAxesInverse, &offsetWristInverse, &iteratedInverse})
    if (!inverse_) inverse_ = make(chain_.arm);
}

Eigen::Isometry3d SixAxisArm::bedFromNozzle(const JointValues& values) const {
  return lamina::bedFromNozzle(chain_.whole, values);
}

Jacobian SixAxisArm::jacobian(const JointValues& values) const {
  return lamina::jacobian(chain_.whole, values);
}

InverseSolutions SixAxisArm::solutions(const Eigen::Isometry3d& bed_from_nozzle,
                                       const JointValues& near) const {
  const Eigen::Isometry3d wanted = withoutExternal(chain_, bed_from_nozzle, near);
  InverseSolutions found;
  for (const ArmSolution& solution : inverse_->solutions(wanted, armValues(chain_, near)))
    found.push_back({solution.branch, withArmValues(chain_, near, solution.values)});
  return found;
}

double SixAxisArm::singularityMargin(const JointValues& values) const {
  return inverse_->singularityMargin(armValues(chain_, values));
}

std::map<std::string, Eigen::Isometry3d> SixAxisArm::bedFromLinks(const JointValues& values) const {
  return lamina::bedFromLinks(chain_.whole, values);
}

std::map<std::string, double> SixAxisArm::urdfJoints(const JointValues& values) const {
  return lamina::urdfJoints(chain_.whole, values);
}

const SixAxisArm& requireSixAxisArm(const KinematicModel& model) {
  const auto* arm = dynamic_cast<const SixAxisArm*>(&model);
  if (arm == nullptr) throw InvalidConfig("machine '" + model.name() + "' is no six-axis arm; expected one");
  return *arm;
}

std::unique_ptr<KinematicModel> sixAxisArm(const urdf::ModelInterface& model, const std::string& text) {
  return std::make_unique<SixAxisArm>(armChain(serialChain(model, text)));
}

}  // namespace lamina
