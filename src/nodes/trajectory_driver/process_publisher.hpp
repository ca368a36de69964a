// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "dry_order.hpp"
#include "lamina/trajectory/trajectory_feeder.hpp"

namespace lamina {

/// Sends the process along with the chunks of a trajectory, on process_trajectory.
class ProcessPublisher {
 public:
  explicit ProcessPublisher(ros::NodeHandle& node);

  /// @param begin  when the clock of the points was 0
  /// @param process  off: everything stays safe, whatever the points say
  void send(const TrajectoryChunk& chunk, const ros::Time& begin, const std::string& toolpath_id,
            ProcessUse process);
  /// Sends that everything is off from this instant on.
  void makeSafe(const ros::Time& now);

 private:
  ros::Publisher publisher_;
};

}  // namespace lamina
