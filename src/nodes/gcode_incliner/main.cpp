// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "gcode_incliner.hpp"
#include "parameters.hpp"
#include "shutdown.hpp"

int main(int argc, char** argv) {
  lamina::runNode(argc, argv, {"gcode_incliner"}, [] {
    lamina::GcodeInclinerSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    lamina::applyParameters(schema, ros::NodeHandle("~"));
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    lamina::GcodeIncliner incliner(ros::NodeHandle(), settings);
    ros::MultiThreadedSpinner(2).spin();  // so that a cancel or a second request is heard during a job
  });
}
