// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <mutex>
#include <thread>

#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/monitoring/profile_sensor.hpp"
#include "lamina/streaming/emulator/emulated_machine.hpp"
#include "machine_deposit.hpp"
#include "machine_settings.hpp"
#include "messages.hpp"
#include "motion_queue.hpp"
#include "motion_samples.hpp"

namespace lamina {

/// An emulated machine with Marlin firmware at a pseudo-terminal and a TCP port. It runs received lines,
/// stores its deposit, and measures the deposit with a profile sensor.
///
/// Publishes   machine_position (sensor_msgs/JointState, latched): the axes every `position_spacing_mm` and
///             at every corner; profile (sensor_msgs/PointCloud2, frame sensor): the sensor's view, each with
///             the stamp of a machine_position; at the end of a motion also if empty; deposited
///             (sensor_msgs/PointCloud2, frame bed, latched): the surface of the material
/// Services    machine_rest (lamina/MachineRest): whether all motions were run and published, and up to which
///             stamps
///
/// Stamps are exact: the time the node started plus machine time divided by the speed-up, whenever they are
/// published.
class EmulatedMachineNode {
 public:
  /// @throws DeviceError, FileError as `EmulatedMachine`
  /// @throws InvalidConfig, FileError as `machineOf`
  EmulatedMachineNode(ros::NodeHandle node, const EmulatedMachineSettings& settings);
  ~EmulatedMachineNode();

 private:
  /// Treatment of an empty profile.
  enum class Blank { Published, LeftOut };

  /// Stamps of the last messages published.
  struct LastStamps {
    ros::Time position;
    ros::Time profile;  ///< zero before the first
  };

  bool onMachineRest(lamina_msgs::MachineRest::Request& request,
                     lamina_msgs::MachineRest::Response& response);
  void run();
  void tryExecute(const ExecutedMotion& motion);
  void execute(const ExecutedMotion& motion);
  void lay(const ToolAxisMotion& motion, const MachineTimes& times);
  void endBead();
  void publishPosition(const MotionSample& sample);
  void publishProfile(const MotionSample& sample, Blank blank);
  void publishDeposited();
  ros::Time stampOf(double machine_s) const;

  EmulatedMachineSettings settings_;
  CartesianMachine machine_;
  ros::ServiceServer rest_;  ///< exists for all who see one of the topics
  ros::Publisher position_;
  ros::Publisher profile_;
  ros::Publisher deposited_;
  Eigen::Affine3d bed_from_program_;
  Eigen::Vector3d tool_axis_;  ///< [bed]
  std::unique_ptr<MachineDeposit> deposit_;
  Eigen::Isometry3d surface_from_bed_;
  Box2 shown_;  ///< [frame of the deposit's surface]
  ProfileSensor sensor_;
  MotionQueue motions_;
  double last_end_s_ = -1.0;  ///< machine time of the last position
  mutable std::mutex stamps_mutex_;
  LastStamps last_;         ///< guarded
  bool has_news_ = false;   ///< whether material was not published yet
  bool is_laying_ = false;  ///< whether the bead under way has not ended
  ros::Time start_;
  std::unique_ptr<EmulatedMachine> emulator_;
  std::thread worker_;
};

}  // namespace lamina
