// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_controller_node.hpp"

#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <cmath>

#include "joint_messages.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/kinematics/model/joint_limits.hpp"
#include "names.hpp"
#include "point_cloud.hpp"
#include "stamps.hpp"
#include "tf/transform_lookup.hpp"

namespace lamina {
namespace {

constexpr int kQueue = 1000;
constexpr std::uint32_t kProfiles = 100000;  // that may wait for a slow subscriber, which sees what it lost
constexpr double kSlack = 1e-3;  // mm, rad or a share: what rounding and time between cycles leave

/// Linear joints in the middle of their ranges, rotary ones at 0 or as near to it as they get.
JointValues parked(const KinematicModel& model) {
  const std::vector<DrivenJoint>& joints = model.joints();
  JointValues values(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const bool is_linear = joints[j].kind == JointKind::Linear;
    values[static_cast<Eigen::Index>(j)] =
        is_linear ? 0.5 * (joints[j].low + joints[j].high) : std::clamp(0.0, joints[j].low, joints[j].high);
  }
  return values;
}

/// @throws GoalFault as OLD_HEADER_TIMESTAMP if all points are past
/// @throws InvalidInput if a joint leaves its limits, is too fast, or would have to jump to join the points
void requireFeasible(const TrajectoryChunk& chunk, const KinematicModel& model, const JointState& now) {
  const auto joining = std::find_if(chunk.points.begin(), chunk.points.end(),
                                    [&](const JointState& point) { return point.time_s > now.time_s; });
  if (joining == chunk.points.end())
    throw GoalFault(follow::Result::OLD_HEADER_TIMESTAMP,
                    "the last point is " + numberText(now.time_s - chunk.points.back().time_s) +
                        " s in the past; expected one that is still to come");
  for (std::size_t j = 0; j < model.joints().size(); ++j) {
    const DrivenJoint& joint = model.joints()[j];
    const auto i = static_cast<Eigen::Index>(j);
    const double fastest = joint.max_speed * (1.0 + kSlack);
    for (const JointState& point : chunk.points) {
      if (point.position[i] < joint.low - kSlack || point.position[i] > joint.high + kSlack)
        throw InvalidInput("a point is at " + boundsText(joint, point.position[i], joint.low, joint.high));
      if (std::abs(point.velocity[i]) > fastest)
        throw InvalidInput("a point has the speed of " +
                           boundsText(joint, point.velocity[i], -fastest, fastest));
    }
    const double reach = fastest * (joining->time_s - now.time_s) + kSlack;
    if (std::abs(joining->position[i] - now.position[i]) > reach)
      throw InvalidInput(
          "the next point cannot be come to in time: " +
          boundsText(joint, joining->position[i], now.position[i] - reach, now.position[i] + reach));
  }
}

template <class Message>
using Callback = boost::function<void(const boost::shared_ptr<Message const>&)>;

}  // namespace

SimulatedControllerNode::SimulatedControllerNode(ros::NodeHandle node, const ControllerSettings& settings)
    : settings_(settings),
      model_(kinematicModelOf(settings.machine)),
      transforms_(model_->urdf()),
      epoch_(ros::Time::now()),
      controller_(clock_, *model_, settings.servo, parked(*model_)),
      flow_(settings.plant),
      awaited_(settings.host_wait_s),
      position_(node.advertise<sensor_msgs::JointState>(names::kMachinePosition, kQueue)),
      process_state_(node.advertise<lamina_msgs::ProcessState>(names::kProcessState, kQueue)),
      server_(node, names::kFollowJointTrajectory, false) {
  const Callback<lamina_msgs::ProcessTrajectory> onProcess = [this](const auto& message) {
    process_.accept(*message);
    awaited_.hearProcess(message->header.stamp);
  };
  process_trajectory_ =
      node.subscribe<lamina_msgs::ProcessTrajectory>(names::kProcessTrajectory, kQueue, onProcess);
  const boost::function<void(const ros::TimerEvent&)> tick = [this](const ros::TimerEvent&) { onTick(); };
  timer_ = node.createTimer(ros::Duration(1.0 / settings_.report_hz), tick);
  if (!settings_.deposit_area_mm.empty()) {
    material_.emplace(settings_);
    profile_ = node.advertise<sensor_msgs::PointCloud2>(names::kProfile, kProfiles);
    mountSensor();
  }
  server_.registerGoalCallback([this] { onGoal(); });
  server_.registerPreemptCallback([this] { onPreempt(); });
  server_.start();
  ROS_INFO("simulating %s, %.0f Hz", model_->name().c_str(), settings_.servo.rate_hz);
}

void SimulatedControllerNode::onGoal() {
  catchUp();
  const auto goal = server_.acceptNewGoal();
  try {
    accept(*goal);
  } catch (const GoalFault& fault) {
    giveUp(fault.code(), fault.what());
  } catch (const Error& error) {
    giveUp(follow::Result::INVALID_GOAL, error.what());
  }
}

void SimulatedControllerNode::giveUp(std::int32_t code, const std::string& why) {
  follow::Result result;
  result.error_code = code;
  result.error_string = why;
  ROS_ERROR("goal refused or given up: %s", why.c_str());
  brake();
  server_.setAborted(result, why);
}

void SimulatedControllerNode::brake() {
  controller_.brake();
  awaited_.forgetGoals();
}

/// The client's clock for a time of its own.
ros::Time SimulatedControllerNode::clientStampOf(double time_s) const { return stampOf(time_s - behind_s_); }

/// By how much a goal from rest begins in the past, if a slow host may be late with it [s].
double SimulatedControllerNode::latenessOf(const ros::Time& begin) const {
  const double late_s = clock_.now() - secondsBetween(epoch_, begin);
  return late_s > settings_.host_wait_s ? 0.0 : std::max(0.0, late_s);
}

void SimulatedControllerNode::accept(const follow::Goal& goal) {
  requireJoints(goal.trajectory.joint_names, *model_);
  const GoalTolerances tolerances(goal, *model_, settings_.path_tolerance);
  if (goal.trajectory.points.empty()) throw InvalidInput("a goal without points; expected one at least");
  const ros::Time begin =
      goal.trajectory.header.stamp.isZero() ? clientStampOf(clock_.now()) : goal.trajectory.header.stamp;
  const bool is_at_rest = !controller_.runsOutAt() && controller_.queued() == 0.0;
  if (is_at_rest) behind_s_ = latenessOf(begin);
  TrajectoryChunk chunk;
  for (const auto& point : goal.trajectory.points) {
    chunk.points.push_back(fromMessage(point, goal.trajectory.joint_names, model_->joints()));
    chunk.points.back().time_s = secondsBetween(epoch_, begin) + point.time_from_start.toSec() + behind_s_;
    const std::size_t count = chunk.points.size();
    if (count > 1 && !(chunk.points[count - 1].time_s > chunk.points[count - 2].time_s))
      throw InvalidInput("point " + std::to_string(count - 1) + " is not later than the one before");
  }
  JointState now;
  now.time_s = clock_.now() - 1.0 / settings_.servo.rate_hz;  // of the last cycle or earlier
  now.position = controller_.wanted();
  requireFeasible(chunk, *model_, now);
  controller_.accept(chunk);
  if (!goal.trajectory.header.stamp.isZero()) awaited_.hearGoal(begin);
  goal_end_s_ = chunk.points.back().time_s;
  tolerances_ = tolerances;
}

/// A goal that is cancelled, and not followed by another, brakes the machine.
void SimulatedControllerNode::onPreempt() {
  if (server_.isNewGoalAvailable()) return;
  catchUp();
  brake();
  server_.setPreempted();
}

void SimulatedControllerNode::onTick() {
  catchUp();
  warnOfStarvation();
  if (!server_.isActive()) return;
  const GoalTolerances::Motion motion{controller_.wanted(), controller_.position(), controller_.velocity()};
  const std::string off = tolerances_.faultOnTheWay(motion, *model_);
  if (!off.empty()) return giveUp(follow::Result::PATH_TOLERANCE_VIOLATED, off);
  // While time stands still, more of the goal's motion may come.
  if (clock_.now() < goal_end_s_ || stands_since_) return;
  const std::string far = tolerances_.faultAtTheEnd(motion, *model_);
  if (far.empty()) return server_.setSucceeded();
  if (clock_.now() >= goal_end_s_ + tolerances_.patience())
    giveUp(follow::Result::GOAL_TOLERANCE_VIOLATED, far);
}

void SimulatedControllerNode::catchUp() {
  const double until_s = due();
  for (;;) {
    const double time_s = static_cast<double>(reports_ + 1) / settings_.report_hz;
    if (time_s > until_s) break;
    ++reports_;
    clock_.moveTo(time_s);
    controller_.advance();
    report(stampOf(time_s));
  }
  clock_.moveTo(until_s);
  controller_.advance();
}

/// What its own time waits at: the end of points that run out in motion, and a goal whose process is still to
/// come.
std::optional<double> SimulatedControllerNode::nextWait() const {
  std::optional<double> at_s = controller_.runsOutAt();
  const std::optional<ros::Time> awaited = awaited_.first();
  if (!awaited || process_trajectory_.getNumPublishers() == 0) return at_s;
  const double begin_s = secondsBetween(epoch_, *awaited) + behind_s_;
  return at_s ? std::min(*at_s, begin_s) : begin_s;
}

/// It stands still as long as a slow host may still bring what it waits for.
double SimulatedControllerNode::due() {
  const ros::Time now = ros::Time::now();
  const double now_s = (now - epoch_).toSec() - stood_s_;
  const std::optional<double> wait_s = server_.isActive() ? nextWait() : std::nullopt;
  if (!wait_s || now_s <= *wait_s) {
    stands_since_.reset();
    return now_s;
  }
  if (!stands_since_) stands_since_ = now;
  if ((now - *stands_since_).toSec() >= settings_.host_wait_s) {
    awaited_.forgetGoals();
    return now_s;
  }
  const double stop_s = std::max(*wait_s, clock_.now());
  stood_s_ += std::max(0.0, now_s - stop_s);
  return std::min(now_s, stop_s);
}

void SimulatedControllerNode::warnOfStarvation() {
  const std::size_t starvations = controller_.report().starvations;
  if (starvations == starvations_) return;
  starvations_ = starvations;
  ROS_WARN("nothing left to follow while moving: braking, process off");
}

void SimulatedControllerNode::report(const ros::Time& now) {
  sensor_msgs::JointState state;
  state.header.stamp = now;
  for (const auto& [name, position] : transforms_.positions(model_->urdfJoints(controller_.position()))) {
    state.name.push_back(name);
    state.position.push_back(position);
  }
  position_.publish(state);

  const ros::Duration behind(behind_s_);
  // Nothing is deposited but on the way of a goal.
  ProcessSignals signals = server_.isActive() ? process_.at(now - behind) : safeSignals();
  if (material_) lay(now, signals.flow_mm3_s);
  signals.flow_mm3_s = flow_.at((now - epoch_).toSec(), signals.flow_mm3_s);
  lamina_msgs::ProcessState process = toStateMessage(signals);
  process.header.stamp = now;
  process_state_.publish(process);
  if (server_.isActive()) publishFeedback(now - behind);
}

/// Where the URDF has no sensor, it looks along the nozzle.
void SimulatedControllerNode::mountSensor() {
  if (model_->bedFromLinks(controller_.position()).count(names::kSensorFrame) > 0) return;
  nozzle_from_sensor_ = Eigen::Isometry3d(Eigen::Translation3d(sensorMount(settings_)));
  geometry_msgs::TransformStamped mounted;
  mounted.header.stamp = epoch_;
  mounted.header.frame_id = names::kNozzleFrame;
  mounted.child_frame_id = names::kSensorFrame;
  mounted.transform = toTransformMessage(*nozzle_from_sensor_);
  static_tf_.emplace();
  static_tf_->sendTransform(mounted);
}

Eigen::Isometry3d SimulatedControllerNode::bedFromSensor() const {
  if (nozzle_from_sensor_) return model_->bedFromNozzle(controller_.position()) * *nozzle_from_sensor_;
  return model_->bedFromLinks(controller_.position()).at(names::kSensorFrame);
}

/// Lays what has flowed since the last report, and looks at it.
void SimulatedControllerNode::lay(const ros::Time& now, double asked_mm3_s) {
  const double time_s = (now - epoch_).toSec();
  material_->observe({time_s, model_->bedFromNozzle(controller_.position()).translation(), asked_mm3_s});
  const bool measures = server_.isActive() && (asked_mm3_s == 0.0 || settings_.profile_while_depositing);
  if (!measures || profile_.getNumSubscribers() == 0) return;
  const std::vector<Point3> points = material_->seenFrom(bedFromSensor(), time_s);
  if (points.empty()) return;
  sensor_msgs::PointCloud2 message = toCloudMessage(points);
  message.header.stamp = now + ros::Duration(material_->stampError());
  message.header.frame_id = names::kSensorFrame;
  profile_.publish(message);
}

void SimulatedControllerNode::publishFeedback(const ros::Time& now) {
  follow::Feedback feedback;
  feedback.header.stamp = now;
  feedback.joint_names = jointNames(*model_);
  JointState wanted;
  wanted.position = controller_.wanted();
  wanted.velocity = wanted.acceleration = JointValues::Zero(wanted.position.size());
  JointState actual = wanted;
  actual.position = controller_.position();
  actual.velocity = controller_.velocity();
  JointState error = wanted;
  error.position = wanted.position - actual.position;
  feedback.desired = toMessage(wanted, model_->joints());
  feedback.actual = toMessage(actual, model_->joints());
  feedback.error = toMessage(error, model_->joints());
  server_.publishFeedback(feedback);
}

}  // namespace lamina
