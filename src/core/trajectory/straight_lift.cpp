// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/straight_lift.hpp"

#include <cmath>

#include "lamina/kinematics/model/joint_limits.hpp"
#include "trajectory/pose_correction.hpp"

namespace lamina {
namespace {

constexpr double kLongestStep = 1.0;  // mm

}  // namespace

StraightLift straightLift(const JointValues& from, double height_mm, const KinematicModel& model,
                          const TrajectorySettings& settings) {
  const PoseCorrection correction(model, settings);
  const Eigen::Isometry3d start = model.bedFromNozzle(from);
  const auto steps = static_cast<int>(std::ceil(height_mm / kLongestStep));
  StraightLift lift;
  lift.values.push_back(from);
  lift.step_mm = steps > 0 ? height_mm / steps : 0.0;
  for (int i = 1; i <= steps; ++i) {
    Eigen::Isometry3d asked = start;
    asked.translation() -= start.linear().col(2) * (lift.step_mm * i);
    const auto next = correction.near(lift.values.back(), asked, PoseCorrection::Keep::TipAndToolAxis);
    const auto fault = next ? limitFault(*next, model) : std::nullopt;
    if (!next || fault) {
      lift.stopped_by = fault ? *fault : "no joints hold the tool axis there";
      break;
    }
    lift.values.push_back(*next);
  }
  return lift;
}

}  // namespace lamina
