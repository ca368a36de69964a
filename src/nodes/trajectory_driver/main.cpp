// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "driver_settings.hpp"
#include "lamina/control/run/run_calibration.hpp"
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
    const auto feeding =
        lamina::withFeederOf(settings.calibration, settings.loop, kinematicModelOf(settings.machine)->name());
    settings.loop = feeding.loop;
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    if (settings.is_corrected) ROS_INFO_STREAM(feeding.source);
    const lamina::TrajectoryDriver driver(ros::NodeHandle(), settings);
    ros::AsyncSpinner spinner(2);
    spinner.start();
    while (ros::ok() && !lamina::isStopRequested()) kLookPeriod.sleep();
    driver.awaitRest();
  });
}
