// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>

#include <string>
#include <vector>

namespace lamina::test {

/// ROS time of nodes that a test starts in a namespace of their own. It goes on while the test runs
/// callbacks.
class TestClock {
 public:
  /// @param space  namespace, from the root
  explicit TestClock(const std::string& space)
      : space_(space), node_(space), clock_(node_.advertise<rosgraph_msgs::Clock>("clock", 10)) {
    node_.setParam("use_sim_time", true);
    time_.clock = ros::Time(1000.0);
    const boost::function<void(const ros::WallTimerEvent&)> tick = [this](const ros::WallTimerEvent&) {
      time_.clock += ros::Duration(kTick);
      clock_.publish(time_);
    };
    timer_ = node_.createWallTimer(ros::WallDuration(kTick), tick);
  }

  /// The arguments of a node in that namespace, by this time.
  std::vector<std::string> followedBy(std::vector<std::string> arguments) const {
    arguments.push_back("__ns:=" + space_);
    arguments.push_back("/use_sim_time:=" + space_ + "/use_sim_time");
    arguments.push_back("/clock:=" + space_ + "/clock");
    return arguments;
  }
  void goBack(double time_s) { time_.clock -= ros::Duration(time_s); }

 private:
  static constexpr double kTick = 0.01;  // s
  std::string space_;
  ros::NodeHandle node_;
  ros::Publisher clock_;
  rosgraph_msgs::Clock time_;
  ros::WallTimer timer_;
};

}  // namespace lamina::test
