// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <mutex>

#include "lamina/base/clock.hpp"
#include "messages.hpp"

namespace lamina {

/// Whether the cell that has ordered the job is still there: its status comes twice a second.
class OwnerWatch {
 public:
  /// @param grace_s  [s] without a word of it, after which it is gone; 0 for never
  OwnerWatch(ros::NodeHandle node, double grace_s);

  /// A job of the cell begins: from now on it is listened for.
  void expect();

  /// True once for each time that it is gone.
  bool takeLoss();

  /// Whether it is gone now.
  bool isLost() const;

 private:
  void onStatus(const lamina_msgs::PackmlStatusConstPtr& status);

  SteadyClock clock_;
  double grace_s_;
  mutable std::mutex mutex_;  ///< of everything below
  double heard_s_ = 0.0;
  bool is_told_ = false;
  ros::Subscriber status_;
};

}  // namespace lamina
