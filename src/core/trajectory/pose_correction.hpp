// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/trajectory/trajectory_settings.hpp"

namespace lamina {

/// Brings joints near a pose to it: Newton's method with the least motion of the joints, each in proportion
/// to its greatest speed. The turn about the jet is free.
class PoseCorrection {
 public:
  enum class Keep : std::uint8_t { Tip, TipAndJet };

  PoseCorrection(const Mechanism& mechanism, const TrajectorySettings& settings);

  /// Whether tip and jet are as asked within half the tolerance on lines.
  bool isWithin(const Eigen::Isometry3d& is, const Eigen::Isometry3d& asked) const;

  /// Joint values with tip, or tip and jet, as asked within a hundredth of that; nothing if there are none.
  std::optional<JointValues> near(JointValues values, const Eigen::Isometry3d& asked, Keep keep) const;

  /// Time that joints need from one to the other, as a root of squares [s].
  double distance(const JointValues& from, const JointValues& to) const {
    return (to - from).cwiseQuotient(speeds_).norm();
  }

 private:
  const Mechanism& mechanism_;
  double tip_mm_;
  double jet_rad_;
  JointValues speeds_;
};

}  // namespace lamina
