// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/arm/newton_refinement.hpp"
#include "kinematics/arm/spherical_wrist_arm.hpp"

namespace lamina {
namespace {

constexpr double kExact = 1e-11;  // rad and mm: rounding

class ClosedFormInverse : public ArmInverse {
 public:
  ClosedFormInverse(const SphericalWristArm& geometry, const SerialChain& arm)
      : geometry_(geometry), arm_(arm) {}

  ArmSolutions solutions(const Eigen::Isometry3d& bed_from_nozzle, const ArmValues& near) const override {
    const ArmSolutions found = lamina::solutions(geometry_, bed_from_nozzle, near);
    return geometry_.deviation > kExact ? refined(arm_, bed_from_nozzle, found) : found;
  }

  ArmSines sines(const ArmValues& values) const override { return singularSines(geometry_, values); }

  double singularityMargin(const ArmValues& values) const override {
    const ArmSines sines = singularSines(geometry_, values);
    return std::min({std::abs(sines.shoulder), std::abs(sines.elbow), std::abs(sines.wrist)});
  }

 private:
  SphericalWristArm geometry_;
  SerialChain arm_;
};

}  // namespace

int branchOf(const ArmSines& sines) {
  return (sines.shoulder < 0.0 ? 4 : 0) + (sines.elbow < 0.0 ? 2 : 0) + (sines.wrist < 0.0 ? 1 : 0);
}

std::unique_ptr<const ArmInverse> closedFormInverse(const SerialChain& arm) {
  std::array<Screw, 6> axes;
  std::copy_n(arm.screws.begin(), axes.size(), axes.begin());
  const auto geometry = sphericalWristArm(axes, arm.bed_from_nozzle_at_zero);
  if (!geometry) return nullptr;
  return std::make_unique<ClosedFormInverse>(*geometry, arm);
}

}  // namespace lamina
