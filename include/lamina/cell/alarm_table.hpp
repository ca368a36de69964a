// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lamina {

/// The effect of an alarm on the unit, from the mildest on.
enum class AlarmCategory : std::uint8_t {
  Information,
  Warning,
  Suspend,  ///< the cause is outside the unit
  Hold,     ///< the cause is inside the unit
  Stop,
  Abort,
};

/// The letter of a category in tables: I, W, S, H, T (stop), A.
char letterOf(AlarmCategory category);

/// How the cause of an alarm ends.
enum class AlarmCause : std::uint8_t {
  Event,      ///< over as soon as it has happened
  Condition,  ///< lasts until it is reported as gone by whatever raised the alarm
};

/// A row of the table of alarms.
struct AlarmKind {
  std::uint16_t id = 0;  ///< group x 100 + number
  AlarmCategory category = AlarmCategory::Information;
  AlarmCause cause = AlarmCause::Event;
  const char* title = "";   ///< what has happened, in a few words
  const char* remedy = "";  ///< what the operator has to do, in one sentence
};

/// All alarms of the cell, ordered by ID. Documentation, web page and the texts of the PLC are made from this
/// table.
const std::vector<AlarmKind>& alarmTable();

/// The row of an alarm.
/// @throws InvalidInput if there is none of that ID
const AlarmKind& alarmKind(int id);

/// The table as CSV, in the form in which PLCs import texts: `id,category,title,remedy`, one row a line,
/// after a header.
std::string alarmTableCsv();

}  // namespace lamina
