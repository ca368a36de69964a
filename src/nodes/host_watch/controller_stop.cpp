// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "controller_stop.hpp"

#include <actionlib_msgs/GoalID.h>

#include <algorithm>

namespace lamina {
namespace {

constexpr double kLongestStop = 2.0;  // [s]
const ros::WallDuration kLook(0.01);

bool isFollowed(const actionlib_msgs::GoalStatus& goal) {
  using Status = actionlib_msgs::GoalStatus;
  return goal.status == Status::PENDING || goal.status == Status::ACTIVE ||
         goal.status == Status::PREEMPTING || goal.status == Status::RECALLING;
}

}  // namespace

ControllerStop::ControllerStop() { node_.setCallbackQueue(&queue_); }

void ControllerStop::connect(const std::string& action) {
  if (controllers_.count(action) != 0) return;
  Controller& controller = controllers_[action];
  controller.cancel = node_.advertise<actionlib_msgs::GoalID>(action + "/cancel", 10);
  const boost::function<void(const actionlib_msgs::GoalStatusArrayConstPtr&)> on_status =
      [this, action](const auto& status) { onStatus(action, *status); };
  controller.status = node_.subscribe<actionlib_msgs::GoalStatusArray>(action + "/status", 1, on_status);
}

void ControllerStop::onStatus(const std::string& action, const actionlib_msgs::GoalStatusArray& status) {
  Controller& controller = controllers_[action];
  controller.goals = static_cast<std::size_t>(
      std::count_if(status.status_list.begin(), status.status_list.end(), isFollowed));
  controller.reported_s = clock_.now();
}

MachineStopReport ControllerStop::stop(const std::string& action, const std::function<void()>& begun) {
  connect(action);
  Controller& controller = controllers_[action];
  const double give_up_s = clock_.now() + kLongestStop;
  while (controller.cancel.getNumSubscribers() == 0 && clock_.now() < give_up_s) kLook.sleep();
  if (controller.cancel.getNumSubscribers() == 0)
    return {false, "no controller hears its cancellations", false};
  queue_.callAvailable();  // what it said before
  const double cancelled_s = clock_.now();
  controller.cancel.publish(actionlib_msgs::GoalID());  // without a name: all
  if (begun) begun();
  while (clock_.now() < give_up_s) {
    queue_.callAvailable(kLook);
    if (controller.reported_s > cancelled_s && controller.goals == 0)
      return {true, "it follows no goal", true};
  }
  return {false,
          controller.reported_s > cancelled_s
              ? "it still follows " + std::to_string(controller.goals) + " goals"
              : std::string("it has said nothing since its goals were cancelled"),
          true};
}

}  // namespace lamina
