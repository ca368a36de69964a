// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <vector>

#include "alarm_reports.hpp"
#include "lamina/control/supervision.hpp"

namespace lamina {

/// The alarms of the loop, for the unit.
class LoopAlarms {
 public:
  explicit LoopAlarms(const ros::NodeHandle& node);

  void raise(const RaisedAlarm& alarm);
  /// Reports raised conditions that no longer stand as gone, and raises standing conditions that were not
  /// raised, continuing from a previous instance of the node.
  void settle(const std::vector<RaisedAlarm>& standing);

 private:
  AlarmReports reports_;
};

}  // namespace lamina
