// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "controller_settings.hpp"
#include "parameters.hpp"
#include "shutdown.hpp"
#include "simulated_controller_node.hpp"

int main(int argc, char** argv) {
  lamina::runNode(argc, argv, {"simulated_controller"}, [] {
    lamina::ControllerSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    lamina::applyParameters(schema, ros::NodeHandle("~"));
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    const lamina::SimulatedControllerNode controller(ros::NodeHandle(), settings);
    ros::spin();
  });
}
