// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/server/simple_action_server.h>
#include <ros/init.h>

#include <chrono>
#include <mutex>
#include <string>

#include "lamina/base/progress.hpp"

namespace lamina {

/// Progress that is published as feedback of the action's current goal, at most 20 times a second. It is
/// cancelled by a cancel request, by a newer goal, and when ROS shuts down.
/// @tparam Action  its feedback has `stage` and `fraction`
template <class Action>
class ActionProgress final : public Progress {
 public:
  /// @param server  must outlive the object
  explicit ActionProgress(actionlib::SimpleActionServer<Action>& server) : server_(server) {}

  void report(const std::string& stage, double fraction) override {
    constexpr std::chrono::milliseconds kPeriod(50);
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto now = std::chrono::steady_clock::now();
    if (stage == stage_ && now - last_report_ < kPeriod) return;
    stage_ = stage;
    last_report_ = now;
    decltype(Action().action_feedback.feedback) feedback;
    feedback.stage = stage;
    feedback.fraction = static_cast<float>(fraction);
    server_.publishFeedback(feedback);
  }

  bool isCancelled() const override { return server_.isPreemptRequested() || !ros::ok(); }

 private:
  actionlib::SimpleActionServer<Action>& server_;
  std::mutex mutex_;
  std::string stage_;
  std::chrono::steady_clock::time_point last_report_;
};

}  // namespace lamina
