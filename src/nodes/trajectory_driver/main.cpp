// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "driver_settings.hpp"
#include "parameters.hpp"
#include "shutdown.hpp"
#include "trajectory_driver.hpp"

namespace {

const ros::WallDuration kLookPeriod(0.02);

}  // namespace

int main(int argc, char** argv) {
  lamina::runNode(argc, argv, {"trajectory_driver", lamina::OnSignal::Request}, [] {
    lamina::DriverSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    lamina::applyParameters(schema, ros::NodeHandle("~"));
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    const lamina::TrajectoryDriver driver(ros::NodeHandle(), settings);
    ros::AsyncSpinner spinner(2);
    spinner.start();
    while (ros::ok() && !lamina::isStopRequested()) kLookPeriod.sleep();
    driver.awaitRest();
  });
}
