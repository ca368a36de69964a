// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/node_handle.h>

#include <memory>
#include <mutex>

#include "deposit_following.hpp"
#include "lamina/job/deposit_job.hpp"
#include "messages.hpp"
#include "simulator_settings.hpp"

namespace lamina {

/// Reports the deposits of toolpaths. Its topics and parameters: docs/nodes/deposition_simulator.md.
///
/// A goal that fails publishes and writes nothing.
class DepositionSimulator {
 public:
  /// @param settings  of every goal, as far as it does not override them
  DepositionSimulator(ros::NodeHandle node, const DepositionSimulatorSettings& settings);
  DepositionSimulator(const DepositionSimulator&) = delete;
  DepositionSimulator& operator=(const DepositionSimulator&) = delete;

 private:
  using Goal = lamina_msgs::SimulateDepositionGoal;
  using Result = lamina_msgs::SimulateDepositionResult;

  void onToolpath(const lamina_msgs::ToolpathConstPtr& message);
  void onGoal(const Goal& goal);
  Result simulate(const Goal& goal, Progress& progress);
  lamina_msgs::ToolpathConstPtr latched() const;

  DepositionSimulatorSettings settings_;
  mutable std::mutex mutex_;
  lamina_msgs::ToolpathConstPtr toolpath_;  ///< the last one that came; guarded by `mutex_`
  ros::Publisher deposited_;
  ros::Publisher markers_;
  std::unique_ptr<DepositFollowing> following_;  ///< in mode `follow`
  ros::Subscriber toolpaths_;
  actionlib::SimpleActionServer<lamina_msgs::SimulateDepositionAction> action_;
};

}  // namespace lamina
