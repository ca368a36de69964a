// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>

#include <chrono>
#include <mutex>
#include <string>

#include "lamina/base/progress.hpp"
#include "messages.hpp"

namespace lamina {

/// Progress as the feedback of the action's current goal, at most 20 times a second; cancelled by the goal's
/// cancel, by a newer goal, and when ROS shuts down.
class ActionProgress final : public Progress {
 public:
  explicit ActionProgress(actionlib::SimpleActionServer<lamina_msgs::SliceAction>& server)
      : server_(server) {}

  void report(const std::string& stage, double fraction) override;
  bool isCancelled() const override;

 private:
  actionlib::SimpleActionServer<lamina_msgs::SliceAction>& server_;
  std::mutex mutex_;
  std::string stage_;
  std::chrono::steady_clock::time_point last_report_;
};

}  // namespace lamina
