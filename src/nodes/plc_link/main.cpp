// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "parameters.hpp"
#include "plc_link_node.hpp"
#include "shutdown.hpp"

int main(int argc, char** argv) {
  lamina::runNode(argc, argv, {"plc_link"}, [] {
    lamina::LinkSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    lamina::applyParameters(schema, ros::NodeHandle("~"));
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    const lamina::PlcLinkNode link(ros::NodeHandle(), settings);
    ros::NodeHandle("~").setParam("listening_port", static_cast<int>(link.port()));
    ros::spin();
  });
}
