// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <Eigen/Geometry>
#include <functional>

#include "tf/transform_intake.hpp"
#include "tf/transform_sequence.hpp"

namespace lamina {

/// Receives every pose of the nozzle over the bed that tf reports, in the order of time stamps. Polling tf
/// would miss corners of a machine in accelerated time. Poses at the time stamps of other transforms are
/// included.
class NozzleIntake {
 public:
  /// @param bed_from_nozzle  translation [mm]
  using Receiver = std::function<void(const Eigen::Isometry3d& bed_from_nozzle)>;

  /// Subscribes to tf. The receiver is called from callbacks of the node's queue.
  NozzleIntake(const ros::NodeHandle& node, Receiver receiver);

 private:
  void passDue();

  TransformSequence sequence_;
  TransformIntake transforms_;
  Receiver receiver_;
  ros::WallTimer timer_;
};

}  // namespace lamina
