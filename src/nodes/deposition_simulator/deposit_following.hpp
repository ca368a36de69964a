// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <memory>
#include <string>

#include "lamina/deposition/followed_deposit.hpp"
#include "messages.hpp"
#include "simulator_settings.hpp"
#include "tf/nozzle_intake.hpp"

namespace lamina {

/// Deposits a toolpath behind the machine that runs it, by the nozzle's pose on tf, and publishes the
/// deposit.
class DepositFollowing {
 public:
  DepositFollowing(ros::NodeHandle node, const DepositionSimulatorSettings& settings);

  /// Begins anew with a toolpath. A toolpath that cannot be deposited is reported in the log, and none is
  /// followed.
  void begin(const lamina_msgs::Toolpath& message);

 private:
  void follow(const Point3& tip);
  void publish();
  void publishState();

  static constexpr double kNotPublished = -1.0;  ///< so that a bed that is empty again is shown

  DepositionSimulatorSettings settings_;
  std::unique_ptr<FollowedDeposit> followed_;  ///< empty before the first toolpath
  std::string toolpath_id_;
  double published_mm3_ = 0.0;          ///< extruded volume at the last state
  bool was_complete_ = false;           ///< at the last state
  double cloud_mm3_ = kNotPublished;    ///< extruded volume at the last cloud
  double markers_mm3_ = kNotPublished;  ///< extruded volume at the last markers
  ros::Publisher deposited_;
  ros::Publisher markers_;
  ros::Publisher state_;
  NozzleIntake intake_;
  ros::WallTimer timer_;
};

}  // namespace lamina
