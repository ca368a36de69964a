// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "gcode_streamer.hpp"
#include "lamina/control/run/run_calibration.hpp"
#include "parameters.hpp"
#include "shutdown.hpp"

namespace {

const ros::WallDuration kLookPeriod(0.02);

}  // namespace

int main(int argc, char** argv) {
  lamina::runNode(argc, argv, {"gcode_streamer", lamina::OnSignal::Request}, [] {
    lamina::GcodeStreamerSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    lamina::applyParameters(schema, ros::NodeHandle("~"));
    requireConsistent(settings.stream);
    const auto feeding = lamina::withFeederOf(settings.corrections.calibration, settings.corrections.loop,
                                              buildSpaceOf(settings.machine).name);
    settings.corrections.loop = feeding.loop;
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    if (settings.corrections.is_used) ROS_INFO_STREAM(feeding.source);
    lamina::GcodeStreamer streamer(ros::NodeHandle(), settings);
    // What is asked of a job is answered while a plan is written.
    ros::AsyncSpinner spinner(2);
    spinner.start();
    while (ros::ok() && !lamina::isStopRequested()) kLookPeriod.sleep();
    streamer.awaitRest();
  });
}
