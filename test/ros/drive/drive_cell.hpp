// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib/client/simple_action_client.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Trigger.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "conversions.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "latched.hpp"
#include "messages.hpp"
#include "names.hpp"
#include "ros/wait_until.hpp"

namespace lamina::test {

/// A cell of driver and controller, as a client of it sees it.
class DriveCell {
 public:
  using Client = actionlib::SimpleActionClient<lamina_msgs::DriveToolpathAction>;

  /// What the machine and its process did at one instant.
  struct Report {
    JointValues joints;
    lamina_msgs::ProcessState process;
  };

  DriveCell(const std::string& space, const std::string& machine)
      : model(kinematicModelByName(machine)), node_(space), client_(node_, names::kDriveToolpath, false) {
    const boost::function<void(const sensor_msgs::JointStateConstPtr&)> on_position =
        [this](const auto& message) { hear(*message); };
    const boost::function<void(const lamina_msgs::ProcessStateConstPtr&)> on_process =
        [this](const auto& message) {
          process_at_[message->header.stamp] = *message;
          match();
        };
    const boost::function<void(const lamina_msgs::MachineStateConstPtr&)> on_state =
        [this](const auto& message) {
          if (state != message->state_name) state_stamp_ = message->header.stamp;
          state = message->state_name;
        };
    const boost::function<void(const visualization_msgs::MarkerArrayConstPtr&)> on_findings =
        [this](const auto& message) { findings = message->markers.size(); };
    const boost::function<void(const visualization_msgs::MarkerArrayConstPtr&)> on_part =
        [this](const auto& message) { grown = message->markers.size(); };
    const boost::function<void(const lamina_msgs::ProcessTrajectoryConstPtr&)> on_ahead =
        [this](const auto&) { ++processes; };
    const boost::function<void(const lamina_msgs::TrackingErrorConstPtr&)> on_tracking =
        [this](const auto& message) { tracking = *message; };
    part_ = node_.subscribe<visualization_msgs::MarkerArray>(names::kPartMarkers, 100, on_part);
    ahead_ = node_.subscribe<lamina_msgs::ProcessTrajectory>(names::kProcessTrajectory, 1000, on_ahead);
    tracking_ = node_.subscribe<lamina_msgs::TrackingError>(names::kTrackingError, 100, on_tracking);
    position_ = node_.subscribe<sensor_msgs::JointState>(names::kMachinePosition, 0, on_position);
    process_ = node_.subscribe<lamina_msgs::ProcessState>(names::kProcessState, 0, on_process);
    state_ = node_.subscribe<lamina_msgs::MachineState>(names::kMachineState, 1000, on_state);
    findings_ = node_.subscribe<visualization_msgs::MarkerArray>(names::kCheckMarkers, 10, on_findings);
    toolpath_ = node_.advertise<lamina_msgs::Toolpath>(names::kToolpath, 1, true);
    speed_ = node_.advertise<std_msgs::Float64>(names::kSpeedFactor, 1);
  }

  /// Publishes a toolpath on the bed and asks for it.
  void drive(Toolpath toolpath, const std::string& planned_for) {
    MachineToolpath placed;
    placed.machine = planned_for;
    placed.id = toolpathId(toolpath);
    placed.toolpath = std::move(toolpath);
    waitUntil([&] { return toolpath_.getNumSubscribers() > 0; });
    publishLatched(toolpath_, toMessage(placed));
    ask(placed.id);
  }
  void drive(Toolpath toolpath) { drive(std::move(toolpath), model->name()); }
  void ask(const std::string& id) {
    lamina_msgs::DriveToolpathGoal goal;
    goal.toolpath_id = id;
    goal.dry = dry;
    goal.speed = speed;
    goal.from_waypoint = from_waypoint;
    ask(goal);
  }
  void ask(const lamina_msgs::DriveToolpathGoal& goal) {
    waitUntil([&] { return client_.isServerConnected(); });
    state.clear();
    client_.sendGoal(goal);
  }

  bool isDone() const { return client_.getState().isDone(); }
  bool ends() {
    return waitUntil([&] { return isDone(); });
  }
  /// States come on a topic, results on another.
  bool comesTo(const std::string& wanted) {
    return waitUntil([&] { return state == wanted; });
  }
  lamina_msgs::DriveToolpathResult result() const { return *client_.getResult(); }
  bool calls(const std::string& service) {
    std_srvs::Trigger trigger;
    return node_.serviceClient<std_srvs::Trigger>(service, true).call(trigger) && trigger.response.success;
  }

  /// The status with which a change of the job under way is answered.
  lamina_msgs::Status change(const std::string& setting, double value) {
    lamina_msgs::ChangeJob asked;
    asked.request.setting = setting;
    asked.request.value = value;
    if (!node_.serviceClient<lamina_msgs::ChangeJob>(names::kChangeJob, true).call(asked))
      asked.response.status.message = "the node does not answer";
    return asked.response.status;
  }

  /// Goes on at a share of the planned speeds.
  void setSpeed(double share) {
    waitUntil([&] { return speed_.getNumSubscribers() > 0; });
    std_msgs::Float64 message;
    message.data = share;
    speed_.publish(message);
  }

  /// Index of the last report with a flow; 0 if there is none.
  std::size_t lastDeposit() const {
    std::size_t last = reports.empty() ? 0 : reports.size() - 1;
    while (last > 0 && reports[last].process.flow == 0.0) --last;
    return last;
  }
  bool isDepositing() const { return !reports.empty() && reports.back().process.flow > 0.0; }
  static bool isSafe(const Report& report) {
    const auto& process = report.process;
    return process.flow == 0.0 && !process.laser && !process.wire && !process.powder && !process.gas;
  }
  Eigen::Vector3d tip(const Report& report) const {
    return model->bedFromNozzle(report.joints).translation();
  }
  /// Whether joints are at rest and the process is off from the last change of state on, by the stamps, for a
  /// while.
  bool staysSafe() {
    if (!waitUntil([&] { return reports.size() > firstAfterState() + 15; })) return false;
    const std::size_t first = firstAfterState();
    for (std::size_t i = first; i < reports.size(); ++i)
      if (!isSafe(reports[i]) || (reports[i].joints - reports[first].joints).norm() > 1e-6) return false;
    return true;
  }

  std::unique_ptr<const KinematicModel> model;
  std::vector<Report> reports;  ///< of machine and process
  std::string state;
  std::string dry;                           ///< how what is asked for is run dry
  double speed = 0.0;                        ///< of that
  std::vector<std::uint32_t> from_waypoint;  ///< where what is asked for is begun
  std::size_t findings = 0;                  ///< markers
  std::size_t grown = 0;                     ///< markers of the part
  std::size_t processes = 0;                 ///< that were sent to the controller
  lamina_msgs::TrackingError tracking;       ///< last

 private:
  /// Index of the first report that is younger than the last change of state.
  std::size_t firstAfterState() const {
    std::size_t first = reports.size();
    while (first > 0 && reports[first - 1].process.header.stamp > state_stamp_) --first;
    return first;
  }

  /// Machine and process are reported of on two topics, with the same stamps.
  void match() {
    while (!joints_at_.empty() && !process_at_.empty()) {
      const ros::Time joints_stamp = joints_at_.begin()->first;
      const ros::Time process_stamp = process_at_.begin()->first;
      if (joints_stamp == process_stamp)
        reports.push_back({joints_at_.begin()->second, process_at_.begin()->second});
      if (joints_stamp <= process_stamp) joints_at_.erase(joints_at_.begin());
      if (process_stamp <= joints_stamp) process_at_.erase(process_at_.begin());
    }
  }

  void hear(const sensor_msgs::JointState& message) {
    JointValues joints(static_cast<Eigen::Index>(model->joints().size()));
    for (std::size_t j = 0; j < model->joints().size(); ++j) {
      const DrivenJoint& joint = model->joints()[j];
      for (std::size_t i = 0; i < message.name.size(); ++i)
        if (message.name[i] == joint.name)
          joints[static_cast<Eigen::Index>(j)] =
              message.position[i] * (joint.kind == JointKind::Linear ? 1000.0 : 1.0);
    }
    joints_at_[message.header.stamp] = joints;
    match();
  }

  ros::NodeHandle node_;
  Client client_;
  std::map<ros::Time, JointValues> joints_at_;  ///< that wait for what the process did
  std::map<ros::Time, lamina_msgs::ProcessState> process_at_;
  ros::Time state_stamp_;
  ros::Subscriber position_, process_, state_, findings_, part_, ahead_, tracking_;
  ros::Publisher toolpath_, speed_;
};

}  // namespace lamina::test
