// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <mutex>
#include <string>

#include "driver_settings.hpp"
#include "messages.hpp"

namespace lamina {

/// Why the process cannot be run, by the last message of process_io, in words; empty if it can, or is not
/// required.
/// @param heard  time of that message; zero before the first one
std::string processFault(const ProcessIoDemand& demand, const lamina_msgs::ProcessReady& last,
                         const ros::Time& heard, const ros::Time& now);

/// Watches whether process_io can run the process.
class ProcessIoWatch {
 public:
  ProcessIoWatch(ros::NodeHandle& node, const ProcessIoDemand& demand);

  /// Why the process cannot be run, in words; empty if it can, or is not required.
  std::string fault(const ros::Time& now) const;

 private:
  ProcessIoDemand demand_;
  mutable std::mutex mutex_;  ///< of what follows
  lamina_msgs::ProcessReady last_;
  ros::Time heard_;  ///< zero before the first
  ros::Subscriber ready_;
};

}  // namespace lamina
