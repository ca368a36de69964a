// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/arm/abb_configuration.hpp"

#include <cmath>

#include "kinematics/arm/six_axis_arm.hpp"

namespace lamina {
namespace {

constexpr double kQuarter = M_PI / 2.0;
constexpr double kRounding = 1e-9;  // rad

int quarterTurn(double angle) { return static_cast<int>(std::floor((angle + kRounding) / kQuarter)); }

}  // namespace

bool isSixAxisArm(const KinematicModel& model) { return dynamic_cast<const SixAxisArm*>(&model) != nullptr; }

bool isArm(const KinematicModel& model) { return dynamic_cast<const ArmModel*>(&model) != nullptr; }

AbbConfiguration abbConfiguration(const KinematicModel& arm, const JointValues& values) {
  const SixAxisArm& six_axes = requireSixAxisArm(arm);
  const ArmValues joints = armValues(six_axes.chain(), values);
  return {quarterTurn(joints[0]), quarterTurn(joints[3]), quarterTurn(joints[5]),
          branchOf(six_axes.sines(values))};
}

}  // namespace lamina
