// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/JointState.h>

#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// For how long joints are waited for [s], and whether that has been cancelled.
struct JointWait {
  double longest_s = 0.0;
  std::function<bool()> is_cancelled = [] { return false; };
};

/// Positions of the driven joints of a kinematic model, from `joint_states`. Joints may be spread over
/// several messages.
class PresentJoints {
 public:
  PresentJoints(ros::NodeHandle& node, const KinematicModel& model);

  /// Waits for recent values of all joints.
  /// @param age_s  greatest age of a joint's last report
  /// @throws TimedOut naming the joint that is not reported; Cancelled if the node is asked to stop
  JointValues fresh(double age_s, double wait_s) const;
  /// Why the machine does not stand at a place from which a motion is to begin, with the joint that is off,
  /// or what is not known; empty if it stands there. Reports may be late: waits until it stands there or is
  /// still.
  /// @param most_tip_mm  greatest distance of the tip; 0 for no limit
  /// @param wait  by the clock of the wall, which a simulation that stands still does not stop
  /// @throws as `fresh`; Cancelled if the look is cancelled
  std::string refusalAt(const JointValues& place, double most_tip_mm, double age_s,
                        const JointWait& wait) const;
  /// Whether no joint has moved for `time_s`, by reports that still arrive; the state of a joint that is no
  /// longer reported is unknown. True if no joint was ever reported.
  bool areStillFor(double time_s) const;

 private:
  struct Heard {
    double value = 0.0;  ///< [mm, rad]
    double mark = 0.0;   ///< position at the last motion
    ros::Time at;
    ros::Time moved_at;
  };
  void hear(const sensor_msgs::JointState& state);
  /// A joint that was not reported within `age_s` of now; empty if there is none. Reports long after now are
  /// from before ROS time went back.
  std::string missingWithin(double age_s, const ros::Time& now) const;

  const KinematicModel& model_;
  mutable std::mutex mutex_;
  std::map<std::string, Heard> heard_;
  ros::Subscriber subscriber_;
};

}  // namespace lamina
