// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace lamina {

// ROS has no authentication: whoever reaches a node's ports can command it. So a node can be reached from its
// own host only, unless ROS_IP, ROS_HOSTNAME, `__ip` or `__hostname` says otherwise (docs/cell/security.md).

/// Makes the node announce 127.0.0.1 if neither ROS_IP nor ROS_HOSTNAME is set and its master is on this
/// host. To be called before ros::init.
void stayOnLoopback(int argc, char** argv);

/// Makes the kernel drop what other hosts send to the listening sockets of this process, as roscpp binds its
/// XML-RPC server to all interfaces, whatever ROS_IP is. Sockets on the loopback interface are not changed.
/// Needs no privilege.
/// @return ports that stay open because their socket accepts no filter
std::vector<std::uint16_t> closeToOtherHosts();

/// Closes the ports of a node that has joined ROS, if it announces the loopback interface, and logs the open
/// ports (`exposureWarnings`).
void guardPorts();

}  // namespace lamina
