// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "host_watch_node.hpp"
#include "parameters.hpp"
#include "shutdown.hpp"

int main(int argc, char** argv) {
  lamina::runNode(argc, argv, {"host_watch"}, [] {
    lamina::HostWatchNodeSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    lamina::applyParameters(schema, ros::NodeHandle("~"));
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    const lamina::HostWatchNode watch(ros::NodeHandle(), settings);
    ros::spin();
  });
}
