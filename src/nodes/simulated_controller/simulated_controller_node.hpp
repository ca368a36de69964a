// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/node_handle.h>

#include <memory>

#include "controller_settings.hpp"
#include "follow_joint_trajectory.hpp"
#include "lamina/base/clock.hpp"
#include "machine_transforms.hpp"
#include "process_queue.hpp"

namespace lamina {

/// Seconds of ROS since it was made.
class RosClock final : public Clock {
 public:
  RosClock() : epoch_(ros::Time::now()) {}
  double now() const override { return (ros::Time::now() - epoch_).toSec(); }
  const ros::Time& epoch() const { return epoch_; }

 private:
  ros::Time epoch_;
};

/// A machine or robot that is not there: follows joint trajectories as its controller would, goal after goal,
/// and reports where it is and what its process does. Its action and topics:
/// docs/nodes/simulated_controller.md.
class SimulatedControllerNode {
 public:
  /// @throws InvalidConfig if the machine is unknown
  SimulatedControllerNode(ros::NodeHandle node, const ControllerSettings& settings);

 private:
  using Server = actionlib::SimpleActionServer<follow::Action>;

  void onGoal();
  void onPreempt();
  void accept(const follow::Goal& goal);
  void onTick();
  void warnOfStarvation();
  void report(const ros::Time& now);
  bool isOutOfTolerance() const;

  ControllerSettings settings_;
  std::unique_ptr<const KinematicModel> model_;
  MachineTransforms transforms_;
  RosClock clock_;
  SimulatedController controller_;
  ProcessQueue process_;
  ros::Publisher position_;
  ros::Publisher process_state_;
  ros::Subscriber process_trajectory_;
  ros::Timer timer_;
  double goal_end_s_ = 0.0;
  std::size_t starvations_ = 0;  ///< that were reported of
  Server server_;
};

}  // namespace lamina
