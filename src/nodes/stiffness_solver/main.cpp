// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "parameters.hpp"
#include "shutdown.hpp"
#include "stiffness_solver.hpp"

int main(int argc, char** argv) {
  lamina::runNode(argc, argv, {"stiffness_solver"}, [] {
    lamina::JobSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    lamina::applyParameters(schema, ros::NodeHandle("~"));
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    const lamina::StiffnessSolver solver(ros::NodeHandle(), settings);
    ros::spin();
  });
}
