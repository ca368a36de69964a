// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/arm/six_axis_arm.hpp"

#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

using MakeInverse = std::unique_ptr<const ArmInverse> (*)(const SerialChain&);

struct NamedClass {
  const char* name;
  MakeInverse make;
};

}  // namespace

ClassifiedInverse classifiedInverse(const SerialChain& arm) {
  constexpr NamedClass kClasses[] = {{"spherical wrist", &closedFormInverse},
                                     {"three parallel axes", &parallelAxesInverse},
                                     {"wrist with an offset", &offsetWristInverse}};
  for (const NamedClass& each : kClasses)
    if (auto inverse = each.make(arm)) return {std::move(inverse), each.name};
  return {iteratedInverse(arm), "any other, by iteration"};
}

SixAxisArm::SixAxisArm(ArmChain chain)
    : ArmModel(std::move(chain)), inverse_(classifiedInverse(this->chain().arm)) {}

InverseSolutions SixAxisArm::solutions(const Eigen::Isometry3d& bed_from_nozzle,
                                       const JointValues& near) const {
  const Eigen::Isometry3d wanted = withoutExternal(chain(), bed_from_nozzle, near);
  InverseSolutions found;
  for (const ArmSolution& solution : inverse_.inverse->solutions(wanted, armValues(chain(), near)))
    found.push_back({solution.branch, withArmValues(chain(), near, solution.values)});
  return found;
}

double SixAxisArm::singularityMargin(const JointValues& values) const {
  return inverse_.inverse->singularityMargin(armValues(chain(), values));
}

const SixAxisArm& requireSixAxisArm(const KinematicModel& model) {
  const auto* arm = dynamic_cast<const SixAxisArm*>(&model);
  if (arm == nullptr) throw InvalidConfig("machine '" + model.name() + "' is no six-axis arm; expected one");
  return *arm;
}

}  // namespace lamina
