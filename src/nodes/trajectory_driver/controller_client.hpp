// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <ros/node_handle.h>

#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "follow_joint_trajectory.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/trajectory/trajectory_feeder.hpp"

namespace lamina {

/// A report of the controller.
struct ControllerReport {
  ros::Time stamp;     ///< by the controller's clock; zero if it gives none
  JointValues wanted;  ///< [mm, rad]
  JointValues actual;
};

/// The controller that follows joint trajectories, as an action. Every chunk is a goal that replaces the
/// previous one from its first point on.
class ControllerClient {
 public:
  using Listener = std::function<void(const ControllerReport&)>;

  /// @param listener  called from ROS's threads, which hold locks of the client: it must not wait for a lock
  ///   that is held while a chunk is sent
  ControllerClient(ros::NodeHandle& node, const KinematicModel& model, Listener listener);

  /// Full name of the action.
  const std::string& action() const { return action_; }
  /// @throws TimedOut if the controller is not there in time
  void requirePresent(double wait_s);
  /// Forgets the outcome of earlier goals.
  void begin();
  /// @param begin  when the clock of the points was 0
  void send(const TrajectoryChunk& chunk, const ros::Time& begin);
  /// Cancels the goals: the controller stops by itself.
  void cancel();
  /// Why the controller gave up; nothing while it runs, and once it is done.
  std::optional<std::string> failure() const;
  /// Whether the controller has reached the end of the last chunk.
  bool isDone() const;

 private:
  using Client = actionlib::SimpleActionClient<follow::Action>;

  void onDone(std::size_t goal, const actionlib::SimpleClientGoalState& state,
              const follow::Result::ConstPtr& result);
  void onFeedback(const follow::Feedback::ConstPtr& feedback);

  const KinematicModel& model_;
  Listener listener_;
  std::string action_;
  mutable std::mutex mutex_;  ///< of what follows
  std::size_t goals_ = 0;
  std::optional<std::string> failure_;
  bool is_done_ = false;
  Client client_;
};

}  // namespace lamina
