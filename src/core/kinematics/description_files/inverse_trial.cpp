// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/description_files/inverse_trial.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lamina/base/random.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {
namespace {

constexpr double kTrialPlace = 1e-4;    // mm
constexpr double kTrialTurn = 1e-7;     // rad
constexpr double kSameDrawn = 1e-4;     // rad, mm
constexpr double kFarthestDrawn = 1e3;  // mm of a rail without an end
constexpr double kOutOfReach = 1e5;     // mm: beyond any arm

JointValues drawnJoints(const KinematicModel& arm, Random& random) {
  JointValues values(static_cast<Eigen::Index>(arm.joints().size()));
  for (std::size_t j = 0; j < arm.joints().size(); ++j) {
    const DrivenJoint& joint = arm.joints()[j];
    const double most = joint.kind == JointKind::Linear ? kFarthestDrawn : M_PI;
    values[static_cast<Eigen::Index>(j)] =
        random.uniform(std::max(joint.low, -most), std::min(joint.high, most));
  }
  return values;
}

bool leadsTo(const KinematicModel& arm, const JointValues& values, const Eigen::Isometry3d& pose) {
  const Eigen::Isometry3d led = arm.bedFromNozzle(values);
  return (led.translation() - pose.translation()).norm() <= kTrialPlace &&
         Eigen::Quaterniond(led.linear()).angularDistance(Eigen::Quaterniond(pose.linear())) <= kTrialTurn;
}

/// But for whole turns.
bool isDrawn(const KinematicModel& arm, const JointValues& values, const JointValues& drawn) {
  for (std::size_t j = 0; j < arm.joints().size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    double off = values[index] - drawn[index];
    if (arm.joints()[j].kind == JointKind::Rotary) off = std::remainder(off, 2.0 * M_PI);
    if (std::abs(off) > kSameDrawn) return false;
  }
  return true;
}

}  // namespace

InverseTrial tryInverse(const KinematicModel& arm, std::size_t poses) {
  InverseTrial trial;
  trial.poses = poses;
  Random random(1);
  JointValues drawn;
  for (std::size_t i = 0; i < poses; ++i) {
    drawn = drawnJoints(arm, random);
    const Eigen::Isometry3d pose = arm.bedFromNozzle(drawn);
    const InverseSolutions solutions = arm.solutions(pose, drawn);
    const auto leads = [&](const InverseSolution& each) { return leadsTo(arm, each.values, pose); };
    if (solutions.empty() || !std::all_of(solutions.begin(), solutions.end(), leads)) continue;
    ++trial.reached;
    trial.recovered += std::any_of(solutions.begin(), solutions.end(), [&](const InverseSolution& each) {
      return isDrawn(arm, each.values, drawn);
    });
  }
  if (poses == 0) return trial;
  Eigen::Isometry3d beyond = arm.bedFromNozzle(drawn);
  beyond.translation() += kOutOfReach * Point3::UnitX();
  trial.ends = arm.solutions(beyond, drawn).empty();
  return trial;
}

}  // namespace lamina
