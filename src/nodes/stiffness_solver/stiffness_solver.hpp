// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/node_handle.h>

#include "lamina/base/progress.hpp"
#include "lamina/job/job_settings.hpp"
#include "messages.hpp"

namespace lamina {

/// Puts parts under load on request. Its topics and parameters: docs/nodes/stiffness_solver.md.
///
/// A goal that fails publishes and writes nothing.
class StiffnessSolver {
 public:
  /// @param settings  of every goal, as far as it does not override them
  StiffnessSolver(ros::NodeHandle node, const JobSettings& settings);
  StiffnessSolver(const StiffnessSolver&) = delete;
  StiffnessSolver& operator=(const StiffnessSolver&) = delete;

 private:
  using Goal = lamina_msgs::ComputeStiffnessGoal;
  using Result = lamina_msgs::ComputeStiffnessResult;

  void onGoal(const Goal& goal);
  Result compute(const Goal& goal, Progress& progress);

  JobSettings settings_;
  ros::Publisher points_;
  actionlib::SimpleActionServer<lamina_msgs::ComputeStiffnessAction> action_;
};

}  // namespace lamina
