// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/JointState.h>

#include <map>
#include <mutex>
#include <string>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Where the driven joints of a kinematic model are, as `joint_states` reports. Joints may come in several
/// messages.
class PresentJoints {
 public:
  PresentJoints(ros::NodeHandle& node, const KinematicModel& model);

  /// Waits for them.
  /// @param age_s   since a joint was heard of, at most
  /// @throws TimedOut naming the joint that nothing is heard of; Cancelled if the node is asked to stop
  JointValues fresh(double age_s, double wait_s) const;
  /// Whether no joint has moved for so long, by reports that still come: of one that is no longer reported
  /// nobody knows. True if none was ever heard of.
  bool areStillFor(double time_s) const;

 private:
  struct Heard {
    double value = 0.0;  ///< [mm, rad]
    double mark = 0.0;   ///< where it was when it moved last
    ros::Time at;
    ros::Time moved_at;
  };
  void hear(const sensor_msgs::JointState& state);
  /// A joint that was not heard of within that time of now; empty if there is none. What was heard of long
  /// after now is of before ROS time went back.
  std::string missingWithin(double age_s, const ros::Time& now) const;

  const KinematicModel& model_;
  mutable std::mutex mutex_;
  std::map<std::string, Heard> heard_;
  ros::Subscriber subscriber_;
};

}  // namespace lamina
