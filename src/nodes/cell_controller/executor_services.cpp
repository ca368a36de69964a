// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "executor_services.hpp"

#include <ros/console.h>
#include <std_srvs/Trigger.h>

#include <utility>

#include "messages.hpp"
#include "names.hpp"
#include "service_call.hpp"

namespace lamina {

ExecutorServices::ExecutorServices(ros::NodeHandle node, std::string executor)
    : executor_(std::move(executor)),
      pause_(node.serviceClient<std_srvs::Trigger>(names::kPause)),
      resume_(node.serviceClient<std_srvs::Trigger>(names::kResume)),
      abort_(node.serviceClient<std_srvs::Trigger>(names::kAbort)),
      change_(node.serviceClient<lamina_msgs::ChangeJob>(names::kChangeJob)) {}

void ExecutorServices::call(OrderThread& thread, ros::ServiceClient& service, const std::string& order) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!waiting_.give(order, clock_.now())) return;
  }
  thread.give([this, &service, order] {
    std_srvs::Trigger request;
    // What is refused shows in the state, which then does not change in time.
    if (callService(service.getService(), request) && !request.response.success)
      ROS_WARN_STREAM(executor_ << " refuses the order to " << order << ": " << request.response.message);
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.answer(order);
  });
}

void ExecutorServices::changeFeed(double feed) {
  orders_.give([this, feed] {
    lamina_msgs::ChangeJob call;
    call.request.setting = "feed";
    call.request.value = feed;
    const bool is_answered = callService(change_.getService(), call);
    const std::lock_guard<std::mutex> lock(mutex_);
    feed_answer_ = {feed, is_answered ? call.response.status.message : executor_ + " does not answer"};
  });
}

std::optional<FeedAnswer> ExecutorServices::takeFeedAnswer() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(feed_answer_, std::nullopt);
}

std::string ExecutorServices::takeUnanswered(double patience_s) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return waiting_.take(clock_.now(), patience_s);
}

}  // namespace lamina
