// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/time.h>

#include <functional>
#include <string>

namespace lamina {

/// Report of a node on /diagnostics, each `~diagnostic_period` by ROS time. If ROS time goes back, because a
/// clock was set or a simulation was reset, the next report follows at once: the updater itself would be
/// silent until the former time is reached again.
class NodeDiagnostics {
 public:
  using Fill = std::function<void(diagnostic_updater::DiagnosticStatusWrapper&)>;

  /// @param hardware  device to which the node is connected; "none" without a device
  void begin(const std::string& hardware, const std::string& name, const Fill& fill);
  /// Reports if it is time; to be called a few times a second.
  void update();

 private:
  diagnostic_updater::Updater updater_;
  ros::Time last_;
};

}  // namespace lamina
