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

/// An alarm that was raised and has not been removed yet.
struct ActiveAlarm {
  std::uint16_t id = 0;
  AlarmCategory category = AlarmCategory::Information;
  double value = 0.0;                    ///< in the unit that the message names
  std::string message;                   ///< what is wrong, the value with its unit, and what was expected
  double raised_s = 0.0;                 ///< time at which it was first raised
  std::optional<double> gone_s;          ///< time at which its cause was gone; nothing while it lasts
  std::optional<double> acknowledged_s;  ///< time at which it was acknowledged; nothing if it was not
  std::string acknowledged_by;           ///< name of the user
  std::size_t times = 1;  ///< number of times it was raised, repetitions within a second included
};

/// Whether the alarm stays until its cause is gone and it is acknowledged: categories from Hold on.
bool isLatched(const ActiveAlarm& alarm);

/// The alarm in a sentence: number, what has happened, message.
std::string sentenceOf(const ActiveAlarm& alarm);

/// The active alarms of a unit, oldest first. An alarm below Hold is removed when its cause is gone; from
/// Hold on it must also be acknowledged. The cause of an event is gone as soon as it was raised. An event
/// below Hold stays until it is acknowledged or the unit is reset, so that somebody sees it.
class ActiveAlarms {
 public:
  /// What has happened when an alarm was raised.
  enum class Raised : std::uint8_t {
    Anew,     ///< it was not active
    Again,    ///< it was active: value and message are replaced
    Flooding  ///< it was raised less than a second before: counted, but not to be written or shown again
  };

  /// Raises an alarm.
  /// @throws InvalidInput if the table has no alarm of that ID
  Raised raise(int id, double value, const std::string& message, double now_s);

  /// States that the cause of an alarm is gone; without effect if it is not active.
  void end(int id, double now_s);

  /// Acknowledges an alarm.
  /// @return false if no alarm of that ID is active
  bool acknowledge(int id, const std::string& by, double now_s);

  /// Removes the events below Hold, as a reset of the unit does.
  void forgetEvents();

  /// Conditions, and events from Hold on, that ended or were acknowledged and then came back, all within the
  /// second after their last report, in which repetitions are not reported. Each is returned once, when that
  /// second is over, if it is still active, with the time at which it came back.
  std::vector<ActiveAlarm> takeReturned(double now_s);

  const std::vector<ActiveAlarm>& all() const { return alarms_; }

  /// The alarms of that category and of graver ones.
  std::vector<ActiveAlarm> from(AlarmCategory category) const;

  /// The gravest category of the alarms whose cause is present, acknowledged or not; nothing if there is
  /// none.
  std::optional<AlarmCategory> gravest() const;

 private:
  struct LastReport {
    int id = 0;
    double at_s = 0.0;
    bool is_outdated = false;      ///< whether the alarm was ended or acknowledged since
    std::optional<double> back_s;  ///< time at which it came back since then
  };
  void removeSettled();
  bool isFlooding(int id, double now_s);

  std::vector<ActiveAlarm> alarms_;
  std::vector<LastReport> last_reports_;  ///< one of each alarm that was ever raised
};

}  // namespace lamina
