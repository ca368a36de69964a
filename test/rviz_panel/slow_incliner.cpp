// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slow_incliner.hpp"

#include <actionlib/server/simple_action_server.h>
#include <ros/ros.h>

#include <cstdlib>

#include "messages.hpp"

namespace lamina::test {
namespace {

using lamina_msgs::InclineGoalConstPtr;
using lamina_msgs::Status;
using Server = actionlib::SimpleActionServer<lamina_msgs::InclineAction>;

constexpr double kTick = 0.02;  // s

void incline(Server& server, const InclineGoalConstPtr& goal) {
  lamina_msgs::InclineResult result;
  if (goal->program == "odd.gcode") return server.setAborted(result);
  lamina_msgs::InclineFeedback feedback;
  feedback.stage = "write";
  for (int tick = 0; ros::ok(); ++tick) {
    if (goal->program == "die.gcode" && tick == 5) std::_Exit(0);
    if (server.isPreemptRequested()) break;
    feedback.fraction = 0.25F;
    server.publishFeedback(feedback);
    ros::Duration(kTick).sleep();
  }
  result.status.code = Status::CANCELLED;
  server.setPreempted(result);
}

}  // namespace

int serveSlowly() {
  ros::NodeHandle node;
  Server server(
      node, "slow_incline", [&](const InclineGoalConstPtr& goal) { incline(server, goal); }, false);
  server.start();
  ros::MultiThreadedSpinner(2).spin();
  return 0;
}

}  // namespace lamina::test
