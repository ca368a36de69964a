// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <memory>
#include <string>

#include "bridge_settings.hpp"
#include "follow_joint_trajectory.hpp"
#include "goal_tolerances.hpp"
#include "lamina/servo/emulated_robot.hpp"
#include "node_diagnostics.hpp"
#include "tf/machine_transforms.hpp"

namespace lamina {

/// Leads a robot of Universal Robots by servoj: streams joint trajectories to it, goal after goal, and
/// reports its position. Its action and topics: docs/nodes/servo_bridge.md.
class ServoBridge {
 public:
  /// @throws InvalidConfig if the robot is unknown or has not six rotary joints; DeviceError if it cannot
  ///   listen for the robot
  ServoBridge(ros::NodeHandle node, const ServoBridgeSettings& settings);

  /// Brakes the robot, and aborts the goal under way.
  void end();

 private:
  using Server = actionlib::SimpleActionServer<follow::Action>;

  /// One instant by both clocks.
  struct Epoch {
    ros::Time ros;
    double steady_s = 0.0;
  };
  void onGoal();
  void onPreempt();
  void accept(const follow::Goal& goal);
  void giveUp(std::int32_t code, const std::string& why);
  void onTick();
  void lookAtGoal(const ServojDriveState& state);
  void report(const ServojDriveState& state);
  void publishFeedback(const ServojDriveState& state, const ros::Time& now);
  void logConnection(const std::string& what);

  ServoBridgeSettings settings_;
  std::unique_ptr<const KinematicModel> model_;
  MachineTransforms transforms_;
  std::unique_ptr<EmulatedRobot> emulated_;  ///< set if the robot is emulated
  std::unique_ptr<ServojDrive> drive_;
  SteadyClock clock_;
  Epoch epoch_;                ///< of the motion under way
  double goal_end_s_ = 0.0;    ///< by the steady clock
  GoalTolerances tolerances_;  ///< of the goal under way
  JointValues last_actual_;    ///< of the report before
  ros::Time last_report_;
  JointValues speed_;  ///< of the joints, between the last two reports
  bool has_been_connected_ = false;
  std::string connection_;  ///< state of the connection as last logged
  std::string rights_;      ///< of the thread that leads the robot
  ros::Publisher position_;
  NodeDiagnostics diagnostics_;
  ros::Timer timer_;
  Server server_;
};

}  // namespace lamina
