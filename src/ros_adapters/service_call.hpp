// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

namespace lamina {

/// Calls a service once, over a connection that the client closes. Where the server closes it, as for calls
/// that are not persistent, roscpp may drop the answer that it has received (ros_comm, issue 1976).
/// @param name  resolved in the namespace of the node
/// @return whether an answer came
template <class Service>
bool callService(const std::string& name, Service& call) {
  ros::NodeHandle node;
  ros::ServiceClient client = node.serviceClient<Service>(name, true);
  return client.isValid() && client.call(call);
}

}  // namespace lamina
