// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "bridge_settings.hpp"
#include "parameters.hpp"
#include "servo_bridge.hpp"
#include "shutdown.hpp"

int main(int argc, char** argv) {
  lamina::runNode(argc, argv, {"servo_bridge", lamina::OnSignal::Request}, [] {
    lamina::ServoBridgeSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    lamina::applyParameters(schema, ros::NodeHandle("~"));
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    lamina::ServoBridge bridge(ros::NodeHandle(), settings);
    ros::AsyncSpinner spinner(1);
    spinner.start();
    while (ros::ok() && !lamina::isStopRequested()) ros::WallDuration(0.02).sleep();
    spinner.stop();
    bridge.end();
  });
}
