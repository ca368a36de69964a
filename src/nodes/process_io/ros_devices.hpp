// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <memory>

#include "lamina/process_io/devices/process_device.hpp"

namespace lamina {

/// Of the kinds set_io and topic too.
/// @throws InvalidConfig as `makeProcessDevice`
std::unique_ptr<ProcessDevice> makeRosDevice(const ros::NodeHandle& node, const DeviceTable& table);

}  // namespace lamina
