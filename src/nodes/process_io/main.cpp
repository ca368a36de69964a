// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "parameters.hpp"
#include "process_io.hpp"
#include "process_io_settings.hpp"
#include "shutdown.hpp"

int main(int argc, char** argv) {
  // Devices that are services and topics are still to be reached as the node ends.
  lamina::runNode(argc, argv, {"process_io", lamina::OnSignal::Request}, [] {
    lamina::ProcessIoSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    lamina::applyParameters(schema, ros::NodeHandle("~"));
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    const lamina::ProcessIo process(ros::NodeHandle(), settings);
    ros::AsyncSpinner spinner(2);
    spinner.start();
    while (ros::ok() && !lamina::isStopRequested()) ros::WallDuration(0.02).sleep();
  });
}
