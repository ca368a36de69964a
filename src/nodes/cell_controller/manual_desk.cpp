// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "manual_desk.hpp"

#include <geometry_msgs/TwistStamped.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>

#include <cmath>
#include <utility>

#include "lamina/base/clock.hpp"
#include "lamina/base/error.hpp"
#include "latched.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr double kOrderInterval = 0.05;  // s, well within jog.lease_s
constexpr char kJointFrame[] = "joints";

CellTime presentTime() { return {SteadyClock().now(), ros::WallTime::now().toSec()}; }

ManualStep stepOf(const lamina_msgs::MoveByHand::Request& request) {
  return {request.frame, request.axis, request.step, request.speed};
}

/// Along an axis, or about it where its name begins with r.
geometry_msgs::TwistStamped twistOf(const ManualStep& step, double velocity) {
  geometry_msgs::TwistStamped order;
  order.header.stamp = ros::Time::now();
  order.header.frame_id = step.frame;
  auto& vector = step.axis.size() > 1 ? order.twist.angular : order.twist.linear;
  const char axis = step.axis.back();
  (axis == 'x' ? vector.x : axis == 'y' ? vector.y : vector.z) = velocity;
  return order;
}

sensor_msgs::JointState jointsOf(const ManualStep& step, double velocity) {
  sensor_msgs::JointState order;
  order.header.stamp = ros::Time::now();
  order.name = {step.axis};
  order.velocity = {velocity};
  return order;
}

bool areEqual(const lamina_msgs::ManualState& a, const lamina_msgs::ManualState& b) {
  return a.holder == b.holder && a.remaining == b.remaining && a.moving == b.moving && a.scale == b.scale &&
         a.reason == b.reason && a.joints == b.joints && a.is_linear == b.is_linear;
}

}  // namespace

ManualDesk::ManualDesk(ros::NodeHandle node, CellJournal& journal, std::function<ManualConditions()> unit)
    : journal_(journal),
      unit_(std::move(unit)),
      state_(node.advertise<lamina_msgs::ManualState>(names::kManualState, 10, true)),
      twist_(node.advertise<geometry_msgs::TwistStamped>(names::kJogTwist, 1)),
      joints_(node.advertise<sensor_msgs::JointState>(names::kJogJoints, 1)),
      jog_states_(node.subscribe(names::kJogState, 10, &ManualDesk::onJog, this)),
      orders_(node.advertiseService(names::kMoveByHand, &ManualDesk::onOrder, this)) {
  jog_.scale = 1.0;
}

void ManualDesk::onJog(const lamina_msgs::JogStateConstPtr& state) { jog_ = *state; }

ManualConditions ManualDesk::conditions() const {
  ManualConditions found = unit_();
  found.has_driver = jog_states_.getNumPublishers() > 0;
  if (found.has_driver) found.joints = jog_.joints;
  return found;
}

bool ManualDesk::onOrder(Request& request, lamina_msgs::MoveByHand::Response& response) {
  const CellTime now = presentTime();
  const ManualConditions found = conditions();
  const CommandAnswer answer = answerTo(request, found, now);
  response.result = static_cast<std::uint8_t>(answer.result);
  response.message = answer.reason;
  if (answer.result == CommandResult::Accepted) response.lease = control_.lease();
  follow(now);
  return true;
}

CommandAnswer ManualDesk::answerTo(const Request& request, const ManualConditions& found, CellTime now) {
  const ManualCaller who{request.source, request.lease};
  CommandAnswer answer;
  switch (request.request) {
    case Request::TAKE: {
      const std::uint64_t before = control_.lease();
      answer = control_.take(who, found, now);
      if (answer.result == CommandResult::Accepted) lost_.clear();
      if (answer.result != CommandResult::Accepted || control_.lease() != before)
        keep(request.source, "take the machine by hand", answer.reason, now);
      return answer;
    }
    case Request::STEP:
      return control_.jog(who, stepOf(request), found, now);
    case Request::RELEASE:
      answer = control_.release(who, now);
      keep(request.source, "release the machine", answer.reason, now);
      return answer;
    default:
      return {CommandResult::BadValue, "request is " + std::to_string(request.request) + "; expected 0 to 2"};
  }
}

void ManualDesk::follow(CellTime now) {
  const std::string holder = control_.holder();
  const std::string lost = control_.follow(conditions(), now);
  if (!lost.empty()) lost_ = lost;
  passOn(now.steady_s);  // the machine rests before anything is written
  if (!lost.empty()) keep(holder, "lose the machine", lost, now);
  tell(now);
}

/// What a driver does not hear again for jog.lease_s it ends by itself; what is to end now is told it.
void ManualDesk::passOn(double now_s) {
  const auto& motion = control_.motion();
  if (motion) {
    const bool is_same = sent_ && sent_->frame == motion->frame && sent_->axis == motion->axis &&
                         sent_->step == motion->step && sent_->speed == motion->speed;
    if (is_same && now_s - sent_s_ < kOrderInterval) return;
    send(*motion, std::copysign(motion->speed, motion->step));
    sent_ = motion;
    sent_s_ = now_s;
  } else if (sent_) {
    send(*sent_, 0.0);
    sent_.reset();
  }
}

void ManualDesk::send(const ManualStep& step, double velocity) const {
  if (step.frame == kJointFrame)
    joints_.publish(jointsOf(step, velocity));
  else
    twist_.publish(twistOf(step, velocity));
}

void ManualDesk::keep(const std::string& who, const std::string& what, const std::string& result,
                      CellTime now) {
  const std::string word = result.empty() ? "accepted" : result;
  ROS_INFO_STREAM("'" << who << "': " << what << ": " << word);
  try {
    journal_.add(AuditRow{now.utc_s, who, "", what, word});
  } catch (const Error& error) {
    ROS_ERROR_STREAM_THROTTLE(1.0, "what is done by hand cannot be kept: " << error.what());
  }
}

void ManualDesk::tell(CellTime now) {
  const bool has_driver = jog_states_.getNumPublishers() > 0;
  lamina_msgs::ManualState state;
  state.holder = control_.holder();
  state.remaining = std::ceil(control_.left(now.steady_s));
  state.moving = static_cast<std::uint8_t>(has_driver && jog_.moving != 0);
  state.scale = has_driver && !state.holder.empty() ? jog_.scale : 1.0;
  state.reason = state.holder.empty() ? lost_ : has_driver ? jog_.reason : "";
  if (has_driver) {
    state.joints = jog_.joints;
    state.is_linear = jog_.is_linear;
  }
  if (is_told_ && areEqual(state, told_)) return;
  told_ = state;
  is_told_ = true;
  state.header.stamp = ros::Time::now();
  publishLatched(state_, state);
}

}  // namespace lamina
