// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "operator_page.hpp"
#include "parameters.hpp"
#include "shutdown.hpp"

int main(int argc, char** argv) {
  lamina::runNode(argc, argv, {"operator_page"}, [] {
    lamina::OperatorPageSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    lamina::applyParameters(schema, ros::NodeHandle("~"));
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    const lamina::OperatorPage page(ros::NodeHandle(), settings);
    ros::spin();
  });
}
