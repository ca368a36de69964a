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
constexpr double kRegular = 0.02;       // sine of the distance from a singularity
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

/// How far solutions lead past their pose.
struct PoseErrors {
  double tip_mm = 0.0;
  double turn_rad = 0.0;

  bool isHeld() const { return tip_mm <= kTrialPlace && turn_rad <= kTrialTurn; }
};

/// The greatest of all solutions. The angle of a small turn is that of its vector part: its cosine has none.
PoseErrors errorsOf(const KinematicModel& arm, const InverseSolutions& solutions,
                    const Eigen::Isometry3d& pose) {
  PoseErrors errors;
  for (const auto& [branch, values] : solutions) {
    const Eigen::Isometry3d led = pose.inverse() * arm.bedFromNozzle(values);
    errors.tip_mm = std::max(errors.tip_mm, led.translation().norm());
    errors.turn_rad = std::max(errors.turn_rad,
                               2.0 * std::asin(std::min(1.0, Eigen::Quaterniond(led.linear()).vec().norm())));
  }
  return errors;
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
    const PoseErrors errors = errorsOf(arm, solutions, pose);
    const bool is_regular = arm.singularityMargin(drawn) >= kRegular;
    trial.regular += is_regular ? 1 : 0;
    trial.tip_error_mm = std::max(trial.tip_error_mm, errors.tip_mm);
    trial.turn_error_rad = std::max(trial.turn_error_rad, errors.turn_rad);
    if (solutions.empty() || !errors.isHeld()) continue;
    ++trial.reached;
    const bool is_recovered =
        std::any_of(solutions.begin(), solutions.end(),
                    [&](const InverseSolution& each) { return isDrawn(arm, each.values, drawn); });
    trial.recovered += is_recovered ? 1 : 0;
    trial.regular_recovered += is_recovered && is_regular ? 1 : 0;
  }
  if (poses == 0) return trial;
  Eigen::Isometry3d beyond = arm.bedFromNozzle(drawn);
  beyond.translation() += kOutOfReach * Point3::UnitX();
  trial.ends = arm.solutions(beyond, drawn).empty();
  return trial;
}

}  // namespace lamina
