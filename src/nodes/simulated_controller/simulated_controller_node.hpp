// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/node_handle.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <cstdint>
#include <memory>
#include <optional>

#include "arriving_flow.hpp"
#include "awaited_process.hpp"
#include "controller_settings.hpp"
#include "deposited_material.hpp"
#include "follow_joint_trajectory.hpp"
#include "goal_tolerances.hpp"
#include "lamina/base/manual_clock.hpp"
#include "process_queue.hpp"
#include "tf/machine_transforms.hpp"

namespace lamina {

/// A simulated machine or robot: follows joint trajectories like a controller, goal after goal, and reports
/// its position and process. On an area of its bed it stores its deposit, and measures it with a profile
/// sensor. Its action and topics: docs/nodes/simulated_controller.md.
///
/// Its clock is ROS time less the time for which it stood still. A report describes the time of its stamp,
/// however late it is made; none is left out. Goals and their process may be late by the delay of the first
/// goal; feedback is stamped by the goals' clock.
class SimulatedControllerNode {
 public:
  /// @throws InvalidConfig if the machine is unknown
  SimulatedControllerNode(ros::NodeHandle node, const ControllerSettings& settings);

 private:
  using Server = actionlib::SimpleActionServer<follow::Action>;

  void onGoal();
  void onPreempt();
  void accept(const follow::Goal& goal);
  void giveUp(std::int32_t code, const std::string& why);
  void brake();
  ros::Time clientStampOf(double time_s) const;
  double latenessOf(const ros::Time& begin) const;
  void onTick();
  void warnOfStarvation();
  /// Runs and reports all that is due.
  void catchUp();
  /// Time up to which its own clock may advance [s].
  double due();
  std::optional<double> nextWait() const;
  ros::Time stampOf(double time_s) const { return epoch_ + ros::Duration(time_s); }
  void report(const ros::Time& now);
  void lay(const ros::Time& now, double asked_mm3_s);
  void mountSensor();
  Eigen::Isometry3d bedFromSensor() const;
  void publishFeedback(const ros::Time& now);

  ControllerSettings settings_;
  std::unique_ptr<const KinematicModel> model_;
  MachineTransforms transforms_;
  ManualClock clock_;
  ros::Time epoch_;
  double stood_s_ = 0.0;                   ///< total time for which the clock stood still
  std::optional<ros::Time> stands_since_;  ///< while it does
  double behind_s_ = 0.0;                  ///< delay with which goals are followed after their stamps
  std::uint64_t reports_ = 0;
  SimulatedController controller_;
  ProcessQueue process_;
  ArrivingFlow flow_;
  AwaitedProcess awaited_;
  std::optional<DepositedMaterial> material_;  ///< set if it stores its deposit
  /// In the nozzle's frame [mm]; nothing if the URDF has a sensor.
  std::optional<Eigen::Isometry3d> nozzle_from_sensor_;
  std::optional<tf2_ros::StaticTransformBroadcaster> static_tf_;  ///< of that
  ros::Publisher profile_;
  ros::Publisher position_;
  ros::Publisher process_state_;
  ros::Subscriber process_trajectory_;
  ros::Timer timer_;
  double goal_end_s_ = 0.0;
  GoalTolerances tolerances_;    ///< of the goal under way
  std::size_t starvations_ = 0;  ///< reported so far
  Server server_;
};

}  // namespace lamina
