// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <memory>

#include "camera_intake.hpp"
#include "lamina/base/clock.hpp"
#include "lamina/web/operator_site.hpp"
#include "lamina/web/web_server.hpp"
#include "page_settings.hpp"
#include "ros_desk.hpp"

namespace lamina {

/// The operator's page of a cell on ROS: docs/nodes/operator_page.md.
class OperatorPage {
 public:
  /// @throws Error if it cannot listen, or its folder cannot be used
  OperatorPage(ros::NodeHandle node, const OperatorPageSettings& settings);

 private:
  void onTick();
  void tellExposure();

  OperatorPageSettings settings_;
  SteadyClock clock_;
  ros::Publisher address_;
  RosDesk desk_;
  std::string damaged_store_;  ///< path of the damaged former store; empty if it was intact
  WebStore store_;
  std::unique_ptr<OperatorSite> site_;
  std::unique_ptr<CameraIntake> camera_;
  std::unique_ptr<WebServer> server_;
  ros::WallTimer timer_;
  bool is_exposure_reported_ = false;
};

}  // namespace lamina
