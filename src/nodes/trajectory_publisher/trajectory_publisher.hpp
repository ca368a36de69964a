// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/JointState.h>
#include <std_srvs/Trigger.h>

#include <memory>
#include <optional>

#include "conversions.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "messages.hpp"
#include "playback.hpp"
#include "publisher_settings.hpp"
#include "tf/tf_broadcast.hpp"

namespace lamina {

/// Shows the machine's position: the toolpath played in time, or the machine's own reports. Its topics,
/// transforms, services and parameters: docs/nodes/trajectory_publisher.md.
class TrajectoryPublisher {
 public:
  /// @throws InvalidConfig if the machine is unknown; as `toolpathFromGcodeFile` and `requireRunsOn` if a
  ///   program is to be loaded
  TrajectoryPublisher(ros::NodeHandle node, const PublisherSettings& settings);

 private:
  /// A toolpath being played; never moved, since the playback refers to it.
  struct Shown {
    explicit Shown(MachineToolpath accepted) : placed(std::move(accepted)) {}
    const MachineToolpath placed;
    std::unique_ptr<Playback> playback;
    double at_s = 0.0;
    std::size_t announced_layers = 0;
    bool has_begun = false;  ///< whether the first waypoint was published
  };

  void advertise(ros::NodeHandle& node);
  bool onLoadProgram(lamina_msgs::LoadProgram::Request& request,
                     lamina_msgs::LoadProgram::Response& response);
  /// @return the toolpath's id
  std::string load(const std::string& program);
  void onToolpath(const lamina_msgs::ToolpathConstPtr& message);
  void accept(MachineToolpath placed);
  std::unique_ptr<Playback> playbackOf(const MachineToolpath& placed) const;
  void onMachinePosition(const sensor_msgs::JointStateConstPtr& message);
  void onTick(const ros::TimerEvent& event);
  void announceLayer(const ros::Time& stamp);
  void announceNozzle(const TimeSpan& span, const ros::Time& stamp);
  void publishWaypoints(const ros::Time& until);
  bool wentBack(const ros::Time& stamp) const;
  void publishPlayed(const JointPositions& positions, const ros::Time& stamp);
  void publishPosition(const JointPositions& positions, const sensor_msgs::JointState& state);

  PublisherSettings settings_;
  std::unique_ptr<const KinematicModel> model_;
  std::optional<CartesianMachine> linear_;  ///< the machine, if all its axes are linear
  TfBroadcast tf_;
  ros::Publisher joint_states_;
  ros::Publisher nozzle_path_;
  ros::Publisher joint_trajectory_;
  ros::Publisher cartesian_trajectory_;
  ros::Publisher cartesian_process_;
  ros::Subscriber toolpath_;
  ros::Subscriber machine_position_;
  ros::ServiceServer load_program_;
  ros::ServiceServer play_;
  ros::ServiceServer pause_;
  ros::ServiceServer rewind_;
  ros::Timer timer_;
  std::unique_ptr<Shown> shown_;
  ros::Time last_tick_;
  ros::Time last_stamp_;  ///< of a position that was played
  bool is_playing_ = true;
};

}  // namespace lamina
