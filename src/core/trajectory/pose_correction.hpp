// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/trajectory/trajectory_settings.hpp"

namespace lamina {

/// Moves joint values near a pose to that pose, by Newton's method with the least joint motion, in which each
/// joint is weighted by its greatest speed. Rotation about the tool axis is free.
class PoseCorrection {
 public:
  enum class Keep : std::uint8_t { Tip, TipAndToolAxis };

  PoseCorrection(const KinematicModel& model, const TrajectorySettings& settings);

  /// Whether tip and tool axis deviate from the requested ones by at most half the tolerance on lines.
  bool isWithin(const Eigen::Isometry3d& is, const Eigen::Isometry3d& asked) const;

  /// Joint values whose tip, or tip and tool axis, are as requested to within a hundredth of the tolerance;
  /// nothing if there are none.
  std::optional<JointValues> near(JointValues values, const Eigen::Isometry3d& asked, Keep keep) const;

  /// Root of the sum of the squared times that the joints need from one set of values to the other [s].
  double distance(const JointValues& from, const JointValues& to) const {
    return (to - from).cwiseQuotient(speeds_).norm();
  }

 private:
  const KinematicModel& model_;
  double tip_mm_;
  double tool_axis_rad_;
  JointValues speeds_;
};

}  // namespace lamina
