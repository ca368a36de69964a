// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "controller_client.hpp"

#include <algorithm>
#include <utility>

#include "joint_messages.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "names.hpp"

namespace lamina {
namespace {

trajectory_msgs::JointTrajectory toMessage(const TrajectoryChunk& chunk, const KinematicModel& model,
                                           const ros::Time& begin) {
  const double first_s = chunk.points.front().time_s;
  trajectory_msgs::JointTrajectory message;
  message.header.stamp = begin + ros::Duration(first_s);
  message.joint_names = jointNames(model);
  for (const JointState& state : chunk.points) {
    message.points.push_back(toMessage(state, model.joints()));
    message.points.back().time_from_start = ros::Duration(state.time_s - first_s);
  }
  return message;
}

}  // namespace

ControllerClient::ControllerClient(ros::NodeHandle& node, const KinematicModel& model, Listener listener)
    : model_(model),
      listener_(std::move(listener)),
      action_(node.resolveName(names::kFollowJointTrajectory)),
      client_(node, names::kFollowJointTrajectory, false) {}

void ControllerClient::requirePresent(double wait_s) {
  // A wait of 0 would be one without end.
  if (client_.isServerConnected() || client_.waitForServer(ros::Duration(std::max(wait_s, 1e-3)))) return;
  throw TimedOut("no controller answers on '" + std::string(names::kFollowJointTrajectory) + "' after " +
                 numberText(wait_s) + " s; expected one for " + model_.name());
}

void ControllerClient::begin() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++goals_;  // what is still heard of an earlier goal is of none now
  failure_.reset();
  is_done_ = false;
}

void ControllerClient::send(const TrajectoryChunk& chunk, const ros::Time& begin) {
  follow::Goal goal;
  goal.trajectory = toMessage(chunk, model_, begin);
  std::size_t number = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    number = ++goals_;
    is_done_ = false;
  }
  client_.sendGoal(
      goal, [this, number](const auto& state, const auto& result) { onDone(number, state, result); },
      Client::SimpleActiveCallback(), [this](const auto& feedback) { onFeedback(feedback); });
}

void ControllerClient::cancel() {
  client_.cancelAllGoals();
  // Goals go by a topic of their own: one that is overtaken by its cancel is refused by its time as it comes.
  // Not in a simulation, whose reset would have the goals that follow refused too.
  if (ros::Time::isSystemTime()) client_.cancelGoalsAtAndBeforeTime(ros::Time::now());
}

std::optional<std::string> ControllerClient::failure() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return failure_;
}

bool ControllerClient::isDone() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return is_done_;
}

void ControllerClient::onDone(std::size_t goal, const actionlib::SimpleClientGoalState& state,
                              const follow::Result::ConstPtr& result) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (goal != goals_) return;  // another took its place
  is_done_ = true;
  if (state == actionlib::SimpleClientGoalState::SUCCEEDED) return;
  failure_ = names::kGoalEnded + state.toString();
  if (result && !result->error_string.empty()) *failure_ += ": " + result->error_string;
}

void ControllerClient::onFeedback(const follow::Feedback::ConstPtr& feedback) {
  try {
    const auto& joints = model_.joints();
    listener_({feedback->header.stamp, fromMessage(feedback->desired, feedback->joint_names, joints).position,
               fromMessage(feedback->actual, feedback->joint_names, joints).position});
  } catch (const Error& error) {
    ROS_ERROR_THROTTLE(5.0, "report of the controller refused: %s", error.what());
  }
}

}  // namespace lamina
