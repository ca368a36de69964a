// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

namespace lamina {

/// Calls a service once, over a connection that the client closes. With calls that are not persistent the
/// server closes the connection, and roscpp may then drop an answer that it has received (ros_comm, issue
/// 1976).
/// @param name  resolved in the node's namespace
/// @return whether an answer was received
template <class Service>
bool callService(const std::string& name, Service& call) {
  ros::NodeHandle node;
  ros::ServiceClient client = node.serviceClient<Service>(name, true);
  return client.isValid() && client.call(call);
}

}  // namespace lamina
