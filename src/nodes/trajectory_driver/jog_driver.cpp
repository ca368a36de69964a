// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "jog_driver.hpp"

#include <ros/ros.h>

#include <cmath>
#include <cstdint>
#include <utility>

#include "conversions.hpp"
#include "drive_clock.hpp"
#include "jog_end.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/verification/collision/checked_bodies.hpp"
#include "lamina/verification/collision/joint_clearance.hpp"
#include "latched.hpp"
#include "names.hpp"

namespace lamina {
namespace {

constexpr double kTellPeriod = 0.1;   // s between reports
constexpr double kJogSettling = 0.2;  // s after which a jog begins anew, from where the joints are reported
constexpr double kBlockLook = 0.02;   // s

class NeverCancelled final : public Progress {
 public:
  void report(const std::string& /*stage*/, double /*fraction*/) override {}
  bool isCancelled() const override { return false; }
};

}  // namespace

JogDriver::JogDriver(ros::NodeHandle& node, const DriverSettings& settings, const KinematicModel& model,
                     const ExecutorOwner& owner, JogLinks links)
    : settings_(settings),
      model_(model),
      owner_(owner),
      links_(std::move(links)),
      publisher_(node.advertise<lamina_msgs::JogState>(names::kJogState, 10, true)),
      lease_(settings.jog.lease_s) {
  state_.joints.reserve(model_.joints().size());
  state_.is_linear.reserve(model_.joints().size());
  for (const DrivenJoint& joint : model_.joints()) {
    state_.joints.push_back(joint.name);
    state_.is_linear.push_back(static_cast<std::uint8_t>(joint.kind == JointKind::Linear));
  }
  tell(ros::Time::now());  // who moves the machine by hand sees what there is to move
  const boost::function<void(const Event<geometry_msgs::TwistStamped>&)> on_twist =
      [this](const auto& event) { onTwist(event); };
  const boost::function<void(const Event<sensor_msgs::JointState>&)> on_joints = [this](const auto& event) {
    onJoints(event);
  };
  // The last order alone counts.
  twist_ = node.subscribe<geometry_msgs::TwistStamped>(names::kJogTwist, 1, on_twist);
  joints_ = node.subscribe<sensor_msgs::JointState>(names::kJogJoints, 1, on_joints);
  const boost::function<void(const ros::TimerEvent&)> look = [this](const ros::TimerEvent&) {
    const std::lock_guard<std::mutex> lock(mutex_);
    dropIfTimeWentBack(ros::Time::now());
    if (!is_rest_reported_) tell(ros::Time::now());
  };
  timer_ = node.createTimer(ros::Duration(kTellPeriod), look);
}

void JogDriver::block(const std::function<bool()>& is_cancelled) {
  const ros::Time begin = ros::Time::now();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_blocked_ = true;
    if (!jog_) return;
  }
  while (!isOver((ros::Time::now() - begin).toSec(), is_cancelled())) ros::WallDuration(kBlockLook).sleep();
}

/// Whether the jog that a job waits for is over; it is then no more. One that is stopped remains until the
/// controller is at rest: the next job waits for that.
bool JogDriver::isOver(double waited_s, bool is_cancelled) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const ros::Time now = ros::Time::now();
  dropIfTimeWentBack(now);
  if (!jog_) return true;
  const bool was_moved = jog_->restTime() > 0.0;
  const bool is_at_rest = !was_moved || (!isMoving(now) && links_.controller.isDone());
  try {
    if (!isJogOver({is_at_rest, is_cancelled}, waited_s)) return false;
  } catch (const Error&) {
    // Whoever stops a job expects a machine that stops, and at once.
    if (is_at_rest)
      jog_.reset();
    else
      links_.controller.cancel();
    tell(now);
    throw;
  }
  jog_.reset();
  tell(now);
  return true;
}

void JogDriver::allow() {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_blocked_ = false;
}

void JogDriver::onTwist(const Event<geometry_msgs::TwistStamped>& event) {
  const auto& message = event.getConstMessage();
  give(event.getPublisherName(), message->header.frame_id,
       [&](const JointValues& position) { return orderOf(*message, position); });
}

void JogDriver::onJoints(const Event<sensor_msgs::JointState>& event) {
  const auto& message = event.getConstMessage();
  give(event.getPublisherName(), "joints",
       [&](const JointValues& /*position*/) { return orderOf(*message); });
}

void JogDriver::give(const std::string& holder, const std::string& frame, const MakeOrder& make) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const ros::Time now = ros::Time::now();
  state_.frame = frame;
  dropIfTimeWentBack(now);
  if (lease_.holder(lease_clock_.now()).empty()) failure_.clear();
  try {
    std::string refusal = is_blocked_ ? "a job is under way; expected its end, or its abort, before a jog"
                                      : owner_.refusal(holder);
    if (refusal.empty()) refusal = lease_.renew(holder, lease_clock_.now());
    if (refusal.empty() && !failure_.empty())
      refusal = failure_ + "; the machine is jogged again once no order has come for jog.lease_s";
    if (!refusal.empty()) throw Rejected(refusal);
    beginIfAtRest(now);
    const JogAnswer answer = follow(holder, make);
    state_.scale = answer.scale;
    state_.reason = answer.reason;
  } catch (const Error& error) {
    state_.scale = 0.0;
    state_.reason = error.what();
    ROS_WARN_THROTTLE(1.0, "%s is not jogged by %s: %s", frame.c_str(), holder.c_str(), error.what());
  }
  tell(now);
}

/// The points of a jog are of a time that comes once more, and its controller may follow them then.
void JogDriver::dropIfTimeWentBack(const ros::Time& now) {
  const bool went_back = now + ros::Duration(kSetBack) < looked_at_;
  looked_at_ = now;
  if (!went_back || !jog_) return;
  ROS_WARN("ROS time went back; what is left of a jog is dropped");
  links_.controller.cancel();
  jog_.reset();
  lease_ = JogLease(settings_.jog.lease_s);
  tell(now);
}

/// From where the joints are, as reported, and as often as a jog begins.
void JogDriver::beginIfAtRest(const ros::Time& now) {
  const std::optional<std::string> failure = jog_ ? links_.controller.failure() : std::nullopt;
  if (failure) {
    // A key that is still held must not start the motion that has just failed again.
    failure_ = *failure;
    jog_.reset();
    throw DeviceError(*failure);
  }
  if (jog_ && (now - begin_).toSec() < jog_->restTime() + kJogSettling) return;
  links_.controller.requirePresent(0.0);
  const JointValues here = links_.joints.fresh(kJogSettling, 0.0);
  if (!links_.joints.areStillFor(kJogSettling))
    throw Rejected("the joints still move; expected them at rest for " + numberText(kJogSettling) +
                   " s before a jog begins");
  // Not while time passes for a motion.
  if (settings_.is_clearance_checked && !bodies_) bodies_ = checkedBodies(model_);
  links_.controller.begin();
  links_.departs(here);
  jog_.emplace(model_, settings_.jog, settings_.run.timing.trajectory.joint_ramp_s, here);
  begin_ = ros::Time::now();
}

JogAnswer JogDriver::follow(const std::string& holder, const MakeOrder& make) {
  const auto send = [this] {
    if (jog_->chunk().points.empty()) return;  // it came too late to be followed
    is_under_way_ = true;
    // First what is to happen on the way, which is nothing; then the way.
    links_.process.send(jog_->chunk(), begin_, "", ProcessUse::Off);
    links_.controller.send(jog_->chunk(), begin_);
  };
  const JogGuard guard = [this](const std::vector<JointValues>& places) { return collisionOn(places); };
  const JogClock clock = [this] { return (ros::Time::now() - begin_).toSec(); };
  const double now_s = clock();
  // What cannot be read changes nothing: what is under way ends with its lease.
  const JogOrder order = make(jog_->at(now_s + settings_.jog.reaction_s).position);
  try {
    JogAnswer answer = jog_->order(order, now_s, settings_.is_clearance_checked ? guard : JogGuard(), clock);
    send();
    return answer;
  } catch (const InvalidInput&) {
    ROS_WARN_THROTTLE(1.0, "an order to jog by %s cannot be carried out; the machine rests", holder.c_str());
    send();
    throw;
  }
}

JogOrder JogDriver::orderOf(const geometry_msgs::TwistStamped& message, const JointValues& position) const {
  const std::string& frame = message.header.frame_id;
  Eigen::Matrix3d bed_from_frame = Eigen::Matrix3d::Identity();
  if (frame == names::kNozzleFrame)
    bed_from_frame = model_.bedFromNozzle(position).linear();
  else if (frame == names::kPartFrame)
    bed_from_frame = links_.bed_from_part();
  else if (frame == names::kBaseFrame)
    bed_from_frame = bedFromBase(position);
  else if (frame != names::kBedFrame)
    throw InvalidInput("a jog is in frame '" + frame + "'; expected nozzle, part, bed or base_link");
  const auto& linear = message.twist.linear;
  const auto& angular = message.twist.angular;
  JogOrder order;
  order.kind = JogOrder::Kind::Nozzle;
  order.linear_mm_s = bed_from_frame * Eigen::Vector3d(toMillimetres(linear.x), toMillimetres(linear.y),
                                                       toMillimetres(linear.z));
  order.angular_velocity_rad_s = bed_from_frame * Eigen::Vector3d(angular.x, angular.y, angular.z);
  return order;
}

/// Joints that are not named rest.
JogOrder JogDriver::orderOf(const sensor_msgs::JointState& message) const {
  if (message.name.empty() || message.name.size() != message.velocity.size())
    throw InvalidInput("a jog names " + std::to_string(message.name.size()) + " joints with " +
                       std::to_string(message.velocity.size()) +
                       " velocities; expected as many, and at least one");
  JogOrder order;
  order.rates = JointValues::Zero(static_cast<Eigen::Index>(model_.joints().size()));
  for (std::size_t i = 0; i < message.name.size(); ++i) {
    bool is_known = false;
    for (std::size_t j = 0; j < model_.joints().size(); ++j) {
      const DrivenJoint& joint = model_.joints()[j];
      if (joint.name != message.name[i]) continue;
      is_known = true;
      order.rates[static_cast<Eigen::Index>(j)] =
          joint.kind == JointKind::Linear ? toMillimetres(message.velocity[i]) : message.velocity[i];
    }
    if (!is_known) throw InvalidInput(model_.name() + " has no joint '" + message.name[i] + "' to jog");
  }
  return order;
}

Eigen::Matrix3d JogDriver::bedFromBase(const JointValues& position) const {
  const auto links = model_.bedFromLinks(position);
  const auto base = links.find(names::kBaseFrame);
  if (base == links.end())
    throw InvalidInput(model_.name() + " has no link base_link to jog in; expected bed or nozzle");
  return base->second.linear();
}

/// What the way runs into first, in words. A machine that touches something already is not moved by hand.
std::string JogDriver::collisionOn(const std::vector<JointValues>& places) {
  Path travel;
  travel.role = PathRole::Travel;
  JointPath path;
  for (const JointValues& place : places) {
    path.at.push_back({0, 0, travel.points.size()});
    path.values.push_back(place);
    travel.points.emplace_back(model_.bedFromNozzle(place).translation());
  }
  Toolpath toolpath;
  toolpath.layers.push_back({0.0, 0.0, {travel}});
  NeverCancelled progress;
  const JointClearanceReport report = checkJointClearance(
      {toolpath, Eigen::Isometry3d::Identity(), model_, path}, *bodies_, settings_.clearance, progress);
  if (report.collisions.empty()) return "";
  const Collision& first = report.collisions.front();
  return "link '" + first.link + "' would run into " +
         (first.obstacle == Obstacle::Machine ? "link '" + first.other + "'" : "the bed");
}

bool JogDriver::isMoving(const ros::Time& now) const {
  return jog_ && (now - begin_).toSec() < jog_->restTime();
}

void JogDriver::tell(const ros::Time& now) {
  state_.header.stamp = now;
  state_.holder = lease_.holder(lease_clock_.now());
  state_.moving = is_under_way_ = isMoving(now);
  is_rest_reported_ = !state_.moving && state_.holder.empty();
  publishLatched(publisher_, state_);
}

}  // namespace lamina
