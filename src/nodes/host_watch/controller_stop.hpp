// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <functional>
#include <map>
#include <string>

#include "lamina/base/clock.hpp"
#include "lamina/streaming/guard/machine_stop.hpp"

namespace lamina {

/// Stops controllers that follow joint trajectories, by cancelling all their goals. For one thread.
class ControllerStop {
 public:
  ControllerStop();
  ControllerStop(const ControllerStop&) = delete;
  ControllerStop& operator=(const ControllerStop&) = delete;

  /// Opens the connection to a controller, once: a stop then does not wait for the connection.
  /// @param action  full name of its action
  void connect(const std::string& action);
  /// Returns once the controller has reported that it follows no goal, after 2 s at the latest.
  /// @param begun  called once the cancellation has left; may be empty
  MachineStopReport stop(const std::string& action, const std::function<void()>& begun);

 private:
  struct Controller {
    ros::Publisher cancel;
    ros::Subscriber status;
    std::size_t goals = 0;    ///< number of goals followed by the last status
    double reported_s = 0.0;  ///< when that status came
  };
  void onStatus(const std::string& action, const actionlib_msgs::GoalStatusArray& status);

  SteadyClock clock_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  std::map<std::string, Controller> controllers_;
};

}  // namespace lamina
