// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <memory>

#include "lamina/process_io/devices/process_device.hpp"

namespace lamina {

/// As `makeProcessDevice`, also for the kinds set_io and topic.
/// @throws InvalidConfig as `makeProcessDevice`
std::unique_ptr<ProcessDevice> makeRosDevice(const ros::NodeHandle& node, const DeviceTable& table);

}  // namespace lamina
