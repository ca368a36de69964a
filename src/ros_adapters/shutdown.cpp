// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shutdown.hpp"

#include <ros/ros.h>

#include <csignal>
#include <cstdio>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

// roscpp handles SIGINT alone; on SIGTERM a node would die with its port open and its file half written.
void requestShutdown(int) { ros::requestShutdown(); }

void logFailure(const Failure& failure) {
  if (ros::ok())
    ROS_FATAL("%s: %s", toString(failure.code), failure.message.c_str());
  else
    std::fprintf(stderr, "%s: %s\n", toString(failure.code), failure.message.c_str());
}

}  // namespace

int runNode(int argc, char** argv, const std::string& name, const std::function<void()>& body) {
  int exit_code = 0;
  try {
    ros::init(argc, argv, name);
    std::signal(SIGTERM, requestShutdown);
    const ros::NodeHandle keeps_ros_started;
    body();
  } catch (...) {
    logFailure(currentFailure());
    exit_code = 1;
  }
  ros::shutdown();
  return exit_code;
}

}  // namespace lamina
