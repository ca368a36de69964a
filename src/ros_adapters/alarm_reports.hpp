// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "messages.hpp"

namespace lamina {

/// Alarms of one source, on `alarm_reports`. A new subscriber receives the conditions that stand, and for
/// each other condition that it is gone: conditions of a node that died are thus ended. Thread-safe.
class AlarmReports {
 public:
  /// @param source      name of the node
  /// @param conditions  IDs of the alarms that last until their end; all others are events
  AlarmReports(ros::NodeHandle node, std::string source, std::vector<std::uint16_t> conditions);

  /// @param value    measured value in the unit of the table of alarms; 0 if there is none
  /// @param message  the reason, in a sentence
  void raise(std::uint16_t id, double value, const std::string& message);
  /// Reports a condition as gone if it stands.
  void end(std::uint16_t id);
  bool stands(std::uint16_t id);

 private:
  lamina_msgs::AlarmReport endOf(std::uint16_t id) const;

  std::string source_;
  std::vector<std::uint16_t> conditions_;
  std::mutex mutex_;
  std::map<std::uint16_t, lamina_msgs::AlarmReport> standing_;
  ros::Publisher reports_;
};

}  // namespace lamina
