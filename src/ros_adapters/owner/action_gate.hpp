// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/action_definition.h>
#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/ros.h>

#include <string>
#include <utility>

#include "owner/executor_owner.hpp"

namespace lamina {

/// A gate before an action server that passes only messages of the server's owner. A server of actionlib does
/// not know who has sent a goal, and ends the current job for any new goal. Goals of other nodes are rejected
/// with the reason; their cancel requests are ignored, with a warning. Without an owner there is no gate.
///
/// The server itself runs under the name `inner(name, owner)`.
template <class Action>
class ActionGate {
 public:
  ACTION_DEFINITION(Action)

  static std::string inner(const std::string& name, const ExecutorOwner& owner) {
    return owner.isAnybody() ? name : name + "/of_owner";
  }

  ActionGate(ros::NodeHandle node, const std::string& name, ExecutorOwner owner) : owner_(std::move(owner)) {
    if (owner_.isAnybody()) return;
    const std::string behind = inner(name, owner_);
    goals_ = node.advertise<ActionGoal>(behind + "/goal", kQueue);
    cancels_ = node.advertise<actionlib_msgs::GoalID>(behind + "/cancel", kQueue);
    results_ = node.advertise<ActionResult>(name + "/result", kQueue);
    subscribers_[0] = forward<ActionResult>(node, behind + "/result", results_);
    feedback_ = node.advertise<ActionFeedback>(name + "/feedback", kQueue);
    subscribers_[1] = forward<ActionFeedback>(node, behind + "/feedback", feedback_);
    statuses_ = node.advertise<actionlib_msgs::GoalStatusArray>(name + "/status", kQueue, true);
    subscribers_[2] = forward<actionlib_msgs::GoalStatusArray>(node, behind + "/status", statuses_);
    const boost::function<void(const ros::MessageEvent<const ActionGoal>&)> on_goal =
        [this](const auto& event) { onGoal(event); };
    const boost::function<void(const ros::MessageEvent<const actionlib_msgs::GoalID>&)> on_cancel =
        [this](const auto& event) { onCancel(event); };
    subscribers_[3] = node.subscribe<ActionGoal>(name + "/goal", kQueue, on_goal);
    subscribers_[4] = node.subscribe<actionlib_msgs::GoalID>(name + "/cancel", kQueue, on_cancel);
  }
  ActionGate(const ActionGate&) = delete;
  ActionGate& operator=(const ActionGate&) = delete;

 private:
  static constexpr int kQueue = 50;

  template <class Message>
  ros::Subscriber forward(ros::NodeHandle& node, const std::string& from, ros::Publisher& to) {
    const boost::function<void(const boost::shared_ptr<const Message>&)> pass = [&to](const auto& message) {
      to.publish(message);
    };
    return node.subscribe<Message>(from, kQueue, pass);
  }

  void onGoal(const ros::MessageEvent<const ActionGoal>& event) {
    const std::string refusal = owner_.refusal(event.getPublisherName());
    if (refusal.empty()) return goals_.publish(event.getConstMessage());
    ROS_WARN_STREAM("a goal is refused: " << refusal);
    ActionResult result;
    result.header.stamp = ros::Time::now();
    result.status.goal_id = event.getConstMessage()->goal_id;
    result.status.status = actionlib_msgs::GoalStatus::REJECTED;
    result.status.text = refusal;
    results_.publish(result);
  }

  void onCancel(const ros::MessageEvent<const actionlib_msgs::GoalID>& event) {
    const std::string refusal = owner_.refusal(event.getPublisherName());
    if (refusal.empty()) return cancels_.publish(event.getConstMessage());
    ROS_WARN_STREAM("a cancel is left out: " << refusal);
  }

  ExecutorOwner owner_;
  ros::Publisher goals_;
  ros::Publisher cancels_;
  ros::Publisher results_;
  ros::Publisher feedback_;
  ros::Publisher statuses_;
  ros::Subscriber subscribers_[5];
};

}  // namespace lamina
