// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory_publisher.hpp"

#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <trajectory_msgs/JointTrajectory.h>
#include <trajectory_msgs/MultiDOFJointTrajectory.h>

#include <algorithm>
#include <vector>

#include "conversions.hpp"
#include "description_warning.hpp"
#include "joint_messages.hpp"
#include "lamina/base/error.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/trajectory/nozzle_motion.hpp"
#include "latched.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "refusal_text.hpp"
#include "status.hpp"

namespace lamina {
namespace {

geometry_msgs::Vector3 vectorMessage(const Point3& vector) {
  geometry_msgs::Vector3 message;
  message.x = vector.x();
  message.y = vector.y();
  message.z = vector.z();
  return message;
}

trajectory_msgs::MultiDOFJointTrajectoryPoint pointOf(const NozzleState& state) {
  trajectory_msgs::MultiDOFJointTrajectoryPoint point;
  point.transforms.resize(1);
  point.transforms[0].translation = vectorMessage(kMetresPerMillimetre * state.tip);
  point.transforms[0].rotation = toMessage(state.orientation);
  point.velocities.resize(1);
  point.velocities[0].linear = vectorMessage(kMetresPerMillimetre * state.velocity);
  point.velocities[0].angular = vectorMessage(state.turn);
  return point;
}

/// The waypoints in the part frame, in order, without those nearer than `spacing_mm` to the one before; first
/// and last of each layer always. Header without stamp.
nav_msgs::Path nozzlePath(const Toolpath& toolpath, double spacing_mm) {
  nav_msgs::Path message;
  message.header.frame_id = names::kPartFrame;
  geometry_msgs::PoseStamped pose;
  pose.header = message.header;
  Point3 last = Point3::Zero();
  const auto add = [&](const Path& path, std::size_t waypoint) {
    last = path.points[waypoint];
    pose.pose.position = toMessage(last);
    pose.pose.orientation = toMessage(path.orientation.at(waypoint));
    message.poses.push_back(pose);
  };
  for (const ToolpathLayer& layer : toolpath.layers) {
    for (const Path& path : layer.paths) {
      if (&path == &layer.paths.front()) add(path, 0);
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        const std::size_t end = path.motionEnd(m);
        const bool is_last = &path == &layer.paths.back() && m + 1 == path.motionCount();
        if (is_last || (path.points[end] - last).norm() >= spacing_mm) add(path, end);
      }
    }
  }
  return message;
}

/// Pose and twist of the nozzle over the bed, in its frame; times from the first state. Header without stamp.
/// @param states  at least one
trajectory_msgs::MultiDOFJointTrajectory nozzleTrajectory(const std::vector<NozzleState>& states) {
  trajectory_msgs::MultiDOFJointTrajectory message;
  message.header.frame_id = names::kBedFrame;
  message.joint_names = {names::kNozzleFrame};
  message.points.reserve(states.size());
  for (const NozzleState& state : states) {
    message.points.push_back(pointOf(state));
    message.points.back().time_from_start = ros::Duration(state.time_s - states.front().time_s);
  }
  return message;
}

/// The process at the same times; safe after the last. Header without stamp.
lamina_msgs::ProcessTrajectory nozzleProcess(const std::vector<NozzleState>& states) {
  lamina_msgs::ProcessTrajectory message;
  message.valid_for = ros::Duration(states.back().time_s - states.front().time_s);
  message.points.reserve(states.size());
  for (const NozzleState& state : states) {
    message.points.push_back(toMessage(state.process));
    message.points.back().time_from_start = ros::Duration(state.time_s - states.front().time_s);
  }
  return message;
}

constexpr int kBurst =
    20000;  // positions: what a machine in accelerated time may report while a subscriber is busy
constexpr std::uint32_t kNoBound = 0;  // of a queue: between poses tf goes straight, so none may be lost

/// The machine's description, for those who read it from the parameter server, unless there is one already.
const std::string& described(const KinematicModel& model, ros::NodeHandle& node) {
  constexpr char kDescription[] = "robot_description";
  std::string present;
  if (!node.hasParam(kDescription)) {
    node.setParam(kDescription, model.urdf());
  } else if (node.getParam(kDescription, present)) {
    const std::string warning = descriptionWarning(present, model.urdf());
    if (!warning.empty()) ROS_WARN_STREAM(node.resolveName(kDescription) << " is left as it is: " << warning);
  }
  return model.urdf();
}

/// The machine of three linear axes that a kinematic model is, if it is one.
std::optional<CartesianMachine> linearMachine(const KinematicModel& model) {
  for (const DrivenJoint& joint : model.joints())
    if (joint.kind != JointKind::Linear) return std::nullopt;
  return machineFromUrdf(model.urdf());
}

JointPositions positionsIn(const sensor_msgs::JointState& state) {
  if (state.name.size() != state.position.size())
    throw InvalidInput(std::to_string(state.name.size()) + " axes and " +
                       std::to_string(state.position.size()) + " positions; there must be as many");
  if (state.header.stamp.isZero())
    throw InvalidInput("its stamp is 0 s; expected the time at which the axes stood there");
  JointPositions positions;
  for (std::size_t i = 0; i < state.name.size(); ++i) positions[state.name[i]] = state.position[i];
  return positions;
}

TfBroadcast::LastPositions lastPositionsIn(TrajectoryMode mode) {
  return mode == TrajectoryMode::Follow ? TfBroadcast::LastPositions::Kept
                                        : TfBroadcast::LastPositions::Dropped;
}

/// A service that does one thing.
template <class Action>
ros::ServiceServer trigger(ros::NodeHandle& node, const std::string& name, Action action) {
  using Request = std_srvs::Trigger::Request;
  using Response = std_srvs::Trigger::Response;
  const boost::function<bool(Request&, Response&)> answer = [action](Request&, Response& response) {
    action();
    response.success = true;
    return true;
  };
  return node.advertiseService(name, answer);
}

}  // namespace

TrajectoryPublisher::TrajectoryPublisher(ros::NodeHandle node, const PublisherSettings& settings)
    : settings_(settings),
      model_(kinematicModelOf(settings.machine)),
      linear_(linearMachine(*model_)),
      tf_(node, described(*model_, node), lastPositionsIn(settings.mode)) {
  advertise(node);
  toolpath_ = node.subscribe(names::kToolpath, 1, &TrajectoryPublisher::onToolpath, this);
  if (!settings_.load_program.empty()) load(settings_.load_program);
  if (settings_.mode == TrajectoryMode::Follow) {
    machine_position_ =
        node.subscribe(names::kMachinePosition, kNoBound, &TrajectoryPublisher::onMachinePosition, this,
                       ros::TransportHints().tcpNoDelay());
  } else {
    last_tick_ = ros::Time::now();
    timer_ = node.createTimer(ros::Duration(1.0 / settings_.rate_hz), &TrajectoryPublisher::onTick, this);
  }
  ROS_INFO(
      "machine %s; %s", model_->name().c_str(),
      settings_.mode == TrajectoryMode::Follow ? "following its reports" : "waiting for a toolpath to play");
}

void TrajectoryPublisher::advertise(ros::NodeHandle& node) {
  joint_states_ = node.advertise<sensor_msgs::JointState>(names::kJointStates, kBurst);
  nozzle_path_ = node.advertise<nav_msgs::Path>(names::kNozzlePath, 1, true);
  ros::NodeHandle own("~");
  load_program_ = own.advertiseService("load_program", &TrajectoryPublisher::onLoadProgram, this);
  if (settings_.mode == TrajectoryMode::Follow) return;
  joint_trajectory_ = node.advertise<trajectory_msgs::JointTrajectory>(names::kJointTrajectory, 1, true);
  cartesian_trajectory_ =
      node.advertise<trajectory_msgs::MultiDOFJointTrajectory>(names::kCartesianTrajectory, 1, true);
  cartesian_process_ = node.advertise<lamina_msgs::ProcessTrajectory>(names::kCartesianProcess, 1, true);
  play_ = trigger(own, "play", [this] { is_playing_ = true; });
  pause_ = trigger(own, "pause", [this] { is_playing_ = false; });
  rewind_ = trigger(own, "rewind", [this] {
    if (shown_) shown_->at_s = 0.0, shown_->announced_layers = 0;
  });
}

bool TrajectoryPublisher::onLoadProgram(lamina_msgs::LoadProgram::Request& request,
                                        lamina_msgs::LoadProgram::Response& response) {
  try {
    response.toolpath_id = load(request.program);
  } catch (...) {
    const Failure failure = currentFailure();
    ROS_ERROR_STREAM(refusalText({"show program", request.program, ""}, failure));
    response.status = toMessage(failure);
  }
  return true;
}

std::string TrajectoryPublisher::load(const std::string& program) {
  MachineToolpath placed;
  placed.toolpath = toolpathFromGcodeFile(program, settings_.reading);
  placed.id = toolpathId(placed.toolpath);
  std::string id = placed.id;
  accept(std::move(placed));
  return id;
}

void TrajectoryPublisher::onToolpath(const lamina_msgs::ToolpathConstPtr& message) {
  try {
    accept(fromMessage(*message));
  } catch (...) {
    const Failure failure = currentFailure();
    ROS_ERROR_STREAM(refusalText({"show toolpath", message->id, ""}, failure));
  }
}

void TrajectoryPublisher::accept(MachineToolpath placed) {
  if (linear_)
    requireRunsOn(placed, *linear_);
  else
    requirePlannedFor(placed, model_->name());
  auto shown = std::make_unique<Shown>(std::move(placed));
  if (settings_.mode == TrajectoryMode::Visualise) shown->playback = playbackOf(shown->placed);
  const MachineToolpath& accepted = shown->placed;
  nav_msgs::Path path = nozzlePath(accepted.toolpath, settings_.path_spacing_mm);
  path.header.stamp = ros::Time::now();
  tf_.sendPart(toMessage(accepted.bed_from_part));
  publishLatched(nozzle_path_, path);
  ROS_INFO("toolpath %s of '%s': %zu layers", accepted.id.c_str(), accepted.toolpath.part_name.c_str(),
           accepted.toolpath.layers.size());
  if (shown->playback == nullptr) return;
  ROS_INFO("it is played in %.0f s", shown->playback->time().total_s / settings_.speed_up);
  shown_ = std::move(shown);
}

std::unique_ptr<Playback> TrajectoryPublisher::playbackOf(const MachineToolpath& placed) const {
  if (linear_) return linearPlayback(placed, *linear_, settings_.run.timing.motion);
  NoProgress nobody;
  KinematicModelRun run = runOn(*model_, placed.toolpath, placed.bed_from_part, settings_.run.joints, nobody);
  return jointPlayback(inTime(std::move(run), *model_, settings_.run.timing), *model_, tf_.machine());
}

void TrajectoryPublisher::onMachinePosition(const sensor_msgs::JointStateConstPtr& message) {
  try {
    publishPosition(positionsIn(*message), *message);
  } catch (const Error& error) {
    ROS_ERROR_THROTTLE(5.0, "machine position refused: %s", error.what());
  }
}

void TrajectoryPublisher::onTick(const ros::TimerEvent& event) {
  const double passed_s = std::max(0.0, (event.current_real - last_tick_).toSec());
  last_tick_ = event.current_real;
  if (!shown_) return;
  if (is_playing_ && shown_->has_begun)
    shown_->at_s = std::min(shown_->playback->time().total_s, shown_->at_s + passed_s * settings_.speed_up);
  shown_->has_begun = true;
  announceLayer(event.current_real);
  publishWaypoints(event.current_real);
  publishPlayed(shown_->playback->at(shown_->at_s), event.current_real);
}

/// Those since the last tick, at their own times: between them the nozzle goes straight.
void TrajectoryPublisher::publishWaypoints(const ros::Time& until) {
  Playback& played = *shown_->playback;
  for (double time_s = played.nextWaypointTime(); time_s < shown_->at_s; time_s = played.nextWaypointTime()) {
    const ros::Duration ago((shown_->at_s - time_s) / settings_.speed_up);
    publishPlayed(played.at(time_s), until - ago);
  }
}

/// Ticks and waypoints since the last one are never so much older than it.
bool TrajectoryPublisher::wentBack(const ros::Time& stamp) const {
  return stamp + ros::Duration(1.0 / settings_.rate_hz) < last_stamp_;
}

void TrajectoryPublisher::publishPlayed(const JointPositions& positions, const ros::Time& stamp) {
  if (wentBack(stamp))
    ROS_WARN("ROS time went back by %.3f s: it is played on by the new time", (last_stamp_ - stamp).toSec());
  else if (stamp <= last_stamp_)
    return;  // tf takes one transform at a time
  last_stamp_ = stamp;
  sensor_msgs::JointState state;
  state.header.stamp = stamp;
  for (const auto& [name, position] : positions) {
    state.name.push_back(name);
    state.position.push_back(position);
  }
  publishPosition(positions, state);
}

void TrajectoryPublisher::announceLayer(const ros::Time& stamp) {
  const auto& starts = shown_->playback->time().layer_start_s;
  const auto begun =
      static_cast<std::size_t>(std::upper_bound(starts.begin(), starts.end(), shown_->at_s) - starts.begin());
  if (begun == shown_->announced_layers) return;
  shown_->announced_layers = begun;
  const TimeSpan span{starts[begun - 1],
                      begun < starts.size() ? starts[begun] : shown_->playback->time().total_s};
  trajectory_msgs::JointTrajectory trajectory = shown_->playback->trajectory(span, 1.0 / settings_.rate_hz);
  trajectory.header.stamp = stamp;
  trajectory.header.frame_id = tf_.machine().rootLink();
  publishLatched(joint_trajectory_, trajectory);
  announceNozzle(span, stamp);
}

/// The process goes first: who has the motion has what goes with it.
void TrajectoryPublisher::announceNozzle(const TimeSpan& span, const ros::Time& stamp) {
  const std::vector<NozzleState> states = shown_->playback->nozzle(span, 1.0 / settings_.cartesian_rate_hz);
  lamina_msgs::ProcessTrajectory process = nozzleProcess(states);
  process.header.stamp = stamp;
  process.toolpath_id = shown_->placed.id;
  publishLatched(cartesian_process_, process);
  trajectory_msgs::MultiDOFJointTrajectory nozzle = nozzleTrajectory(states);
  nozzle.header.stamp = stamp;
  publishLatched(cartesian_trajectory_, nozzle);
}

void TrajectoryPublisher::publishPosition(const JointPositions& positions,
                                          const sensor_msgs::JointState& state) {
  tf_.sendLinks(positions, state.header.stamp);
  joint_states_.publish(state);
}

}  // namespace lamina
