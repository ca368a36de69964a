// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "lamina/control/supervision.hpp"

namespace lamina {

/// Whether an alarm is among those raised.
inline bool isAmong(const std::vector<RaisedAlarm>& alarms, LoopAlarm alarm) {
  return std::any_of(alarms.begin(), alarms.end(), [alarm](const auto& each) { return each.alarm == alarm; });
}

/// The alarms of a watch that hold at present. An alarm is reported once for as long as it holds without a
/// break.
class StandingAlarms {
 public:
  /// States which alarms hold now.
  /// @return the alarms that did not hold at the call before
  std::vector<RaisedAlarm> risen(std::vector<RaisedAlarm> now) {
    std::set<LoopAlarm> up;
    std::vector<RaisedAlarm> risen;
    for (RaisedAlarm& alarm : now) {
      up.insert(alarm.alarm);
      if (!isUp(alarm.alarm)) risen.push_back(std::move(alarm));
    }
    up_ = std::move(up);
    return risen;
  }
  bool isUp(LoopAlarm alarm) const { return up_.count(alarm) > 0; }

 private:
  std::set<LoopAlarm> up_;
};

}  // namespace lamina
