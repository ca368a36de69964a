// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "parameters.hpp"
#include "shutdown.hpp"
#include "slicing_service.hpp"

int main(int argc, char** argv) {
  lamina::runNode(argc, argv, {"slicing_service"}, [] {
    lamina::JobSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    lamina::applyParameters(schema, ros::NodeHandle("~"));
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    lamina::SlicingService service(ros::NodeHandle(), settings);
    ros::MultiThreadedSpinner(2).spin();  // so that a cancel or a second request is heard during a job
  });
}
