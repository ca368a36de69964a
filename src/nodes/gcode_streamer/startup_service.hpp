// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include "lamina/startup/startup_session.hpp"
#include "messages.hpp"

namespace lamina {

/// The service run_startup: runs, confirms and aborts the steps of a start-up.
class StartupService {
 public:
  /// @param startup  outlives the service
  StartupService(ros::NodeHandle node, StartupSession& startup);

 private:
  using Request = lamina_msgs::RunStartup::Request;
  using Response = lamina_msgs::RunStartup::Response;

  bool onRequest(Request& request, Response& response);
  void follow(const Request& request);
  void confirm(const Request& request);

  StartupSession& startup_;
  ros::ServiceServer server_;
};

}  // namespace lamina
