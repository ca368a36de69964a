// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <mutex>
#include <optional>
#include <string>

#include "lamina/base/clock.hpp"
#include "machine_executor.hpp"
#include "order_thread.hpp"
#include "unanswered_order.hpp"

namespace lamina {

/// The services by which an executor's job is paused, resumed, ended and changed. Calls return at once.
class ExecutorServices {
 public:
  /// @param executor  name of its node, for messages
  ExecutorServices(ros::NodeHandle node, std::string executor);

  void pause() { call(orders_, pause_, "pause"); }
  void resume() { call(orders_, resume_, "resume"); }
  /// @param order  name of the order, for messages: to stop, or to abort
  void end(const std::string& order) { call(ends_, abort_, order); }
  void changeFeed(double feed);
  std::optional<FeedAnswer> takeFeedAnswer();

  /// The call that has waited for its answer for `patience_s` [s]; returned once, empty if there is none.
  std::string takeUnanswered(double patience_s);

 private:
  void call(OrderThread& thread, ros::ServiceClient& service, const std::string& order);

  std::string executor_;
  SteadyClock clock_;
  ros::ServiceClient pause_;
  ros::ServiceClient resume_;
  ros::ServiceClient abort_;
  ros::ServiceClient change_;
  std::mutex mutex_;  ///< of the call under way
  UnansweredOrder waiting_;
  std::optional<FeedAnswer> feed_answer_;
  // Last, so that they end before the objects they use. Calls that end a job do not wait behind calls that
  // pause it.
  OrderThread orders_;
  OrderThread ends_;
};

}  // namespace lamina
