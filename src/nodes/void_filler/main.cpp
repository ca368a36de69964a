// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "parameters.hpp"
#include "shutdown.hpp"
#include "void_filler.hpp"

int main(int argc, char** argv) {
  lamina::runNode(argc, argv, {"void_filler"}, [] {
    lamina::JobSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    lamina::applyParameters(schema, ros::NodeHandle("~"));
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    const lamina::VoidFiller filler(ros::NodeHandle(), settings);
    ros::MultiThreadedSpinner(2).spin();  // so that a second request is refused during the first
  });
}
