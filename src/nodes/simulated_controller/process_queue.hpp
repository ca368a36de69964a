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
  /// Takes the place of what was sent for its stamp and later. It holds for at most
  /// `ProcessPlan::kLongestHold` behind its last point, whatever it states.
  void accept(const lamina_msgs::ProcessTrajectory& message);
  /// Safe before the first point and once what was sent last has run out.
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
