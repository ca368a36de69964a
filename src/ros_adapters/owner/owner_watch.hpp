// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <mutex>

#include "lamina/base/clock.hpp"
#include "messages.hpp"

namespace lamina {

/// Watches whether the cell that ordered the job is still present. The cell publishes its status twice a
/// second.
class OwnerWatch {
 public:
  /// @param grace_s  [s] without a status, after which the cell counts as lost; 0 for never
  OwnerWatch(ros::NodeHandle node, double grace_s);

  /// States that a job of the cell begins: the watch begins.
  void expect();

  /// Whether the cell was lost; true once for each loss.
  bool takeLoss();

  /// Whether the cell is lost now.
  bool isLost() const;

 private:
  void onStatus(const lamina_msgs::PackmlStatusConstPtr& status);

  SteadyClock clock_;
  double grace_s_;
  mutable std::mutex mutex_;  ///< guards everything below
  double heard_s_ = 0.0;
  bool is_told_ = false;
  ros::Subscriber status_;
};

}  // namespace lamina
