// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lamina/cell/alarm_table.hpp"

namespace lamina {

/// An alarm that somebody raised.
struct ActiveAlarm {
  std::uint16_t id = 0;
  AlarmCategory category = AlarmCategory::Information;
  double value = 0.0;   ///< in the unit that the message names
  std::string message;  ///< what, the value with its unit, what was expected
  double raised_s = 0.0;
  std::optional<double> gone_s;
  std::optional<double> acknowledged_s;
  std::string acknowledged_by;
  std::size_t times = 1;  ///< raised, with those that came within a second
};

/// True if the alarm stays until it is gone and acknowledged: from Hold on.
bool isLatched(const ActiveAlarm& alarm);

/// The alarms of a unit, oldest first. Those below Hold leave when their cause is gone, those from Hold on
/// when they are acknowledged too. An event's cause is gone as soon as it was raised; events below Hold are
/// kept until they are acknowledged or the unit is reset, so that somebody sees them.
class ActiveAlarms {
 public:
  /// What raising an alarm came to.
  enum class Raised : std::uint8_t {
    Anew,
    Again,    ///< it was active: value and message are the new ones
    Flooding  ///< the same within a second of the last: counted, not to be written or shown again
  };

  /// @throws InvalidInput if the table has no alarm of that ID
  Raised raise(int id, double value, const std::string& message, double now_s);

  /// The cause of an alarm is gone. Without effect if it is not active.
  void end(int id, double now_s);

  /// @return false if no alarm of that ID is active
  bool acknowledge(int id, const std::string& by, double now_s);

  /// Forgets the events below Hold: what a reset does.
  void forgetEvents();

  const std::vector<ActiveAlarm>& all() const { return alarms_; }

  /// Those of that category and graver ones.
  std::vector<ActiveAlarm> from(AlarmCategory category) const;

  /// The gravest category whose cause is there, whether it was acknowledged or not.
  std::optional<AlarmCategory> gravest() const;

 private:
  struct LastReport {
    int id = 0;
    double at_s = 0.0;
  };
  void removeSettled();
  bool isFlooding(int id, double now_s);

  std::vector<ActiveAlarm> alarms_;
  std::vector<LastReport> last_reports_;
};

}  // namespace lamina
