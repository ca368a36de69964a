// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/arm/configured_joints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "kinematics/arm/six_axis_arm.hpp"

namespace lamina {
namespace {

constexpr double kQuarterTurn = M_PI / 2.0;
constexpr double kWholeTurn = 2.0 * M_PI;
constexpr double kTargetRounding = 1e-4;  // rad: what the decimals of a target leave of a joint

/// The value in that quarter turn, but for whole turns; nothing if it lies in none of them.
std::optional<double> inQuarter(double value, int quarter) {
  const double middle = (quarter + 0.5) * kQuarterTurn;
  const double turned = value + kWholeTurn * std::round((middle - value) / kWholeTurn);
  if (std::abs(turned - middle) > 0.5 * kQuarterTurn + kTargetRounding) return std::nullopt;
  return turned;
}

}  // namespace

SixJoints sixJointsOf(const KinematicModel& arm, const JointValues& values) {
  return armValues(requireSixAxisArm(arm).chain(), values);
}

JointValues withSixJoints(const KinematicModel& arm, JointValues values, const SixJoints& joints) {
  return withArmValues(requireSixAxisArm(arm).chain(), std::move(values), joints);
}

std::optional<JointValues> configuredJoints(const KinematicModel& arm,
                                            const Eigen::Isometry3d& bed_from_nozzle,
                                            const AbbConfiguration& configuration, const JointValues& near) {
  const ArmChain& chain = requireSixAxisArm(arm).chain();
  const std::array<std::pair<Eigen::Index, int>, 3> quarters = {
      {{0, configuration.cf1}, {3, configuration.cf4}, {5, configuration.cf6}}};
  for (const InverseSolution& solution : arm.solutions(bed_from_nozzle, near)) {
    if (abbConfiguration(arm, solution.values).cfx != configuration.cfx) continue;
    ArmValues joints = armValues(chain, solution.values);
    bool has_all = true;
    for (const auto& [joint, quarter] : quarters) {
      const auto turned = inQuarter(joints[joint], quarter);
      has_all &= turned.has_value();
      joints[joint] = turned.value_or(0.0);
    }
    if (has_all) return withArmValues(chain, solution.values, joints);
  }
  return std::nullopt;
}

std::optional<JointValues> followingJoints(const KinematicModel& arm,
                                           const Eigen::Isometry3d& bed_from_nozzle,
                                           const JointValues& near) {
  const ArmChain& chain = requireSixAxisArm(arm).chain();
  const ArmValues before = armValues(chain, near);
  std::optional<JointValues> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const InverseSolution& solution : arm.solutions(bed_from_nozzle, near)) {
    ArmValues joints = armValues(chain, solution.values);
    for (Eigen::Index j = 0; j < joints.size(); ++j)
      joints[j] += kWholeTurn * std::round((before[j] - joints[j]) / kWholeTurn);
    const double turn = (joints - before).cwiseAbs().maxCoeff();
    if (turn >= least) continue;
    least = turn;
    nearest = withArmValues(chain, solution.values, joints);
  }
  return nearest;
}

}  // namespace lamina
