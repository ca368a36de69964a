// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "lamina/toolpath/process_signals.hpp"
#include "messages.hpp"

namespace lamina {

/// The process as it was sent ahead. Times are those of ROS.
class ProcessQueue {
 public:
  /// Replaces the process from the message's stamp on. A process holds for at most
  /// `ProcessPlan::kLongestHold` after its last point, whatever the message states.
  void accept(const lamina_msgs::ProcessTrajectory& message);
  /// The process at a time; safe before the first point and after the end of the last message.
  ProcessSignals at(const ros::Time& now);

 private:
  struct Timed {
    ros::Time from;
    ProcessSignals signals;
  };
  std::deque<Timed> points_;
  ros::Time valid_until_;
};

}  // namespace lamina
