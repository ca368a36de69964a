// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/trajectory/trajectory_settings.hpp"

namespace lamina {

/// Brings joints near a pose to it: Newton's method with the least motion of the joints, each in proportion
/// to its greatest speed. The turn about the tool axis is free.
class PoseCorrection {
 public:
  enum class Keep : std::uint8_t { Tip, TipAndToolAxis };

  PoseCorrection(const KinematicModel& model, const TrajectorySettings& settings);

  /// Whether tip and tool axis are as asked within half the tolerance on lines.
  bool isWithin(const Eigen::Isometry3d& is, const Eigen::Isometry3d& asked) const;

  /// Joint values with tip, or tip and tool axis, as asked within a hundredth of that; nothing if there are
  /// none.
  std::optional<JointValues> near(JointValues values, const Eigen::Isometry3d& asked, Keep keep) const;

  /// Time that joints need from one to the other, as a root of squares [s].
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
