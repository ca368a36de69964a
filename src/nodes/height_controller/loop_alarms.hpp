// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <map>
#include <mutex>
#include <vector>

#include "lamina/control/supervision.hpp"
#include "messages.hpp"

namespace lamina {

/// The alarms of the loop, on `alarm_reports`. Whoever begins to listen gets the conditions that stand, and
/// of the others that they are gone.
class LoopAlarms {
 public:
  explicit LoopAlarms(ros::NodeHandle node);

  void raise(const RaisedAlarm& alarm);
  /// Reports conditions as gone that were raised and do not stand any more.
  void settle(const std::vector<RaisedAlarm>& standing);

 private:
  std::mutex mutex_;
  std::map<LoopAlarm, RaisedAlarm> raised_;
  ros::Publisher reports_;
};

}  // namespace lamina
