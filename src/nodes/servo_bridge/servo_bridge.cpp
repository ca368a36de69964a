// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "servo_bridge.hpp"

#include <ros/ros.h>
#include <sensor_msgs/JointState.h>

#include <algorithm>
#include <utility>

#include "joint_messages.hpp"
#include "lamina/base/error.hpp"
#include "names.hpp"
#include "servo_diagnostics.hpp"
#include "shutdown.hpp"
#include "stamps.hpp"

namespace lamina {
namespace {

constexpr int kQueue = 1000;
constexpr double kJoin = 0.1;  // s after which a goal begins that is to begin at once

/// Joints at 0, or as near to it as they get.
JointValues parked(const KinematicModel& model) {
  JointValues values(static_cast<Eigen::Index>(model.joints().size()));
  for (std::size_t j = 0; j < model.joints().size(); ++j)
    values[static_cast<Eigen::Index>(j)] = std::clamp(0.0, model.joints()[j].low, model.joints()[j].high);
  return values;
}

JointState stateOf(JointValues position, JointValues velocity) {
  JointState state;
  state.acceleration = JointValues::Zero(position.size());
  state.position = std::move(position);
  state.velocity = std::move(velocity);
  return state;
}

}  // namespace

ServoBridge::ServoBridge(ros::NodeHandle node, const ServoBridgeSettings& settings)
    : settings_(settings),
      model_(kinematicModelOf(settings.machine)),
      transforms_(model_->urdf()),
      last_actual_(parked(*model_)),
      speed_(JointValues::Zero(last_actual_.size())),
      position_(node.advertise<sensor_msgs::JointState>(names::kMachinePosition, kQueue)),
      server_(node, names::kFollowJointTrajectory, false) {
  if (settings_.is_emulated) {
    emulated_ = std::make_unique<EmulatedRobot>(EmulatedRobotSettings{}, parked(*model_));
    settings_.drive.robot.host = "127.0.0.1";
    settings_.drive.robot.script_port = emulated_->port();
  }
  drive_ = std::make_unique<ServojDrive>(model_->joints(), settings_.drive);
  rights_ = drive_->rights();
  diagnostics_.begin(
      settings_.is_emulated ? "none" : settings_.drive.robot.host, "robot",
      [this](auto& diagnostics) { fillDiagnostics(drive_->state(), connection_, rights_, diagnostics); });
  const boost::function<void(const ros::TimerEvent&)> tick = [this](const ros::TimerEvent&) { onTick(); };
  timer_ = node.createTimer(ros::Duration(1.0 / settings_.report_hz), tick);
  server_.registerGoalCallback([this] { onGoal(); });
  server_.registerPreemptCallback([this] { onPreempt(); });
  server_.start();
  ROS_INFO("leading %s at %s, %s; awaited on %s:%d", model_->name().c_str(),
           settings_.is_emulated ? "no address: it is emulated" : settings_.drive.robot.host.c_str(),
           rights_.c_str(), settings_.drive.robot.bind.c_str(), static_cast<int>(drive_->port()));
}

void ServoBridge::end() {
  timer_.stop();
  if (!server_.isActive()) return;
  giveUp(follow::Result::PATH_TOLERANCE_VIOLATED, "the node was ended");
  awaitDelivery();
}

void ServoBridge::onGoal() {
  const auto goal = server_.acceptNewGoal();
  try {
    accept(*goal);
  } catch (const GoalFault& fault) {
    giveUp(fault.code(), fault.what());
  } catch (const Error& error) {
    giveUp(follow::Result::INVALID_GOAL, error.what());
  }
}

void ServoBridge::giveUp(std::int32_t code, const std::string& why) {
  follow::Result result;
  result.error_code = code;
  result.error_string = why;
  ROS_ERROR("goal refused or given up: %s", why.c_str());
  drive_->brake();
  server_.setAborted(result, why);
}

void ServoBridge::accept(const follow::Goal& goal) {
  requireJoints(goal.trajectory.joint_names, *model_);
  const GoalTolerances tolerances(goal, *model_, settings_.path_tolerance);
  // The clocks may drift apart while the robot rests; in motion each goal has to join the one before.
  if (drive_->state().is_at_rest) epoch_ = {ros::Time::now(), clock_.now()};
  const ros::Time& stamp = goal.trajectory.header.stamp;
  const double begin_s =
      stamp.isZero() ? clock_.now() + kJoin : epoch_.steady_s + secondsBetween(epoch_.ros, stamp);
  TrajectoryChunk chunk;
  chunk.points.reserve(goal.trajectory.points.size());
  for (const auto& point : goal.trajectory.points) {
    chunk.points.push_back(fromMessage(point, goal.trajectory.joint_names, model_->joints()));
    chunk.points.back().time_s = begin_s + point.time_from_start.toSec();
  }
  drive_->accept(chunk);
  goal_end_s_ = chunk.points.back().time_s;
  tolerances_ = tolerances;
}

/// A goal that is cancelled, and not followed by another, brakes the robot.
void ServoBridge::onPreempt() {
  if (server_.isNewGoalAvailable()) return;
  drive_->brake();
  server_.setPreempted();
}

void ServoBridge::onTick() {
  const ServojDriveState state = drive_->state();
  report(state);
  lookAtGoal(state);
  logConnection(drive_->keepConnected());
  diagnostics_.update();
}

void ServoBridge::lookAtGoal(const ServojDriveState& state) {
  if (!server_.isActive()) return;
  if (!state.fault.empty()) return giveUp(follow::Result::PATH_TOLERANCE_VIOLATED, state.fault);
  const GoalTolerances::Motion motion{state.wanted.position, state.actual, speed_};
  const std::string off = tolerances_.faultOnTheWay(motion, *model_);
  if (!off.empty()) return giveUp(follow::Result::PATH_TOLERANCE_VIOLATED, off);
  const double now_s = clock_.now();
  if (now_s < goal_end_s_ || !state.is_at_rest) return;
  const std::string far = tolerances_.faultAtTheEnd(motion, *model_);
  if (far.empty()) return server_.setSucceeded();
  if (now_s >= goal_end_s_ + tolerances_.patience()) giveUp(follow::Result::GOAL_TOLERANCE_VIOLATED, far);
}

void ServoBridge::logConnection(const std::string& what) {
  if (what == std::exchange(connection_, what)) return;
  if (what.empty())
    ROS_INFO("the robot is connected");
  else
    ROS_WARN("no robot: %s", what.c_str());
}

void ServoBridge::report(const ServojDriveState& state) {
  has_been_connected_ = has_been_connected_ || state.is_connected;
  if (!has_been_connected_) return;
  const ros::Time now = ros::Time::now();
  const double since_s = (now - last_report_).toSec();
  if (since_s > 0.0) speed_ = (state.actual - last_actual_) / since_s;
  last_actual_ = state.actual;
  last_report_ = now;
  if (state.is_connected) {
    sensor_msgs::JointState message;
    message.header.stamp = now;
    for (const auto& [name, position] : transforms_.positions(model_->urdfJoints(state.actual))) {
      message.name.push_back(name);
      message.position.push_back(position);
    }
    position_.publish(message);
  }
  if (server_.isActive()) publishFeedback(state, now);
}

void ServoBridge::publishFeedback(const ServojDriveState& state, const ros::Time& now) {
  const JointValues none = JointValues::Zero(state.actual.size());
  follow::Feedback feedback;
  feedback.header.stamp = now;
  feedback.joint_names = jointNames(*model_);
  feedback.desired = toMessage(stateOf(state.wanted.position, state.wanted.velocity), model_->joints());
  feedback.actual = toMessage(stateOf(state.actual, speed_), model_->joints());
  feedback.error = toMessage(stateOf(state.wanted.position - state.actual, none), model_->joints());
  server_.publishFeedback(feedback);
}

}  // namespace lamina
