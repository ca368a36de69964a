// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ros_progress.hpp"

#include <ros/init.h>

namespace lamina {
namespace {

constexpr std::chrono::milliseconds kFeedbackPeriod(50);

}  // namespace

void ActionProgress::report(const std::string& stage, double fraction) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (stage == stage_ && now - last_report_ < kFeedbackPeriod) return;
  stage_ = stage;
  last_report_ = now;
  lamina_msgs::SliceFeedback feedback;
  feedback.stage = stage;
  feedback.fraction = static_cast<float>(fraction);
  server_.publishFeedback(feedback);
}

bool ActionProgress::isCancelled() const { return server_.isPreemptRequested() || !ros::ok(); }

}  // namespace lamina
