// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/arm/seven_axis_arm.hpp"

#include <utility>

namespace lamina {

SevenAxisArm::SevenAxisArm(ArmChain chain) : ArmModel(std::move(chain)), inverse_(this->chain().arm) {}

std::string SevenAxisArm::kinematicClass() const {
  return inverse_.isSpherical() ? "seven axes, spherical shoulder and wrist"
                                : "seven axes, any other, by iteration";
}

InverseSolutions SevenAxisArm::solutions(const Eigen::Isometry3d& bed_from_nozzle,
                                         const JointValues& near) const {
  return solutionsWith(bed_from_nozzle, near, angleAt(near));
}

double SevenAxisArm::singularityMargin(const JointValues& values) const {
  return inverse_.singularityMargin(armValues<SevenValues>(chain(), values));
}

double SevenAxisArm::angleAt(const JointValues& values) const {
  return inverse_.armAngle(armValues<SevenValues>(chain(), values));
}

InverseSolutions SevenAxisArm::solutionsWith(const Eigen::Isometry3d& bed_from_nozzle,
                                             const JointValues& near, double angle) const {
  const Eigen::Isometry3d wanted = withoutExternal(chain(), bed_from_nozzle, near);
  const SevenValues kept = armValues<SevenValues>(chain(), near);
  InverseSolutions found;
  for (const SevenSolution& solution : inverse_.solutions(wanted, angle, kept))
    found.push_back({solution.branch, withArmValues(chain(), near, solution.values)});
  return found;
}

}  // namespace lamina
