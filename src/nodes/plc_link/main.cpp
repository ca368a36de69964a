// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include "names.hpp"
#include "parameters.hpp"
#include "plc_link_node.hpp"
#include "shutdown.hpp"

int main(int argc, char** argv) {
  lamina::runNode(argc, argv, {"plc_link"}, [] {
    lamina::LinkSettings settings;
    lamina::SettingsSchema schema;
    describe(schema, settings);
    ros::NodeHandle own("~");
    own.deleteParam(lamina::names::kListeningPortParameter);  // of a run before, which a kill leaves behind
    lamina::applyParameters(schema, own);
    ROS_INFO_STREAM("settings:" << lamina::describeSettings(schema));
    const lamina::PlcLinkNode link(ros::NodeHandle(), settings);
    own.setParam(lamina::names::kListeningPortParameter, static_cast<int>(link.port()));
    ros::spin();
  });
}
