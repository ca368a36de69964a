// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/node_handle.h>

#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "messages.hpp"
#include "study_feedback.hpp"

namespace lamina {

/// Runs studies on request. Its action and parameters: docs/nodes/optimiser.md.
class Optimiser {
 public:
  /// @param search  settings of the search, before those of a study
  Optimiser(const ros::NodeHandle& node, std::vector<SettingText> search);
  Optimiser(const Optimiser&) = delete;
  Optimiser& operator=(const Optimiser&) = delete;

 private:
  using Goal = lamina_msgs::OptimiseGoal;
  using Result = lamina_msgs::OptimiseResult;

  void onGoal(const Goal& goal);
  Result run(const Goal& goal, StudyFeedback& feedback);

  std::vector<SettingText> search_;
  StudyFeedback::Server action_;
};

}  // namespace lamina
