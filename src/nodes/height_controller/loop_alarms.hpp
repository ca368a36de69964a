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
  /// Reports conditions as gone that were raised and do not stand any more, and raises those that stand and
  /// were not, as a node before this one has left them.
  void settle(const std::vector<RaisedAlarm>& standing);

 private:
  AlarmReports reports_;
};

}  // namespace lamina
