// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace lamina {

enum class ReplyKind : std::uint8_t {
  Ok,           ///< one line was taken; may state its number, free buffers, temperatures
  Resend,       ///< the line to send again
  LineError,    ///< the reason for a resend, whose request follows
  Fatal,        ///< the firmware has halted or protects the machine
  Warning,      ///< an error that stops nothing
  Busy,         ///< still alive, and working on what it has
  Start,        ///< the firmware has started, and has forgotten everything
  NotDone,      ///< a command was not run: it is unknown, or the nozzle is too cold to extrude
  Pause,        ///< the machine asks its host to pause, as for filament that has run out
  Resume,       ///< the machine goes on after such a pause
  Cancel,       ///< the machine asks its host to end the job
  Unreadable,   ///< bytes that no firmware sends: noise on the link
  Information,  ///< reports and everything else
};

struct ReportedTemperatures {
  double nozzle_c = 0.0;
  std::optional<double> nozzle_target_c;  ///< nothing if the firmware does not report it
  std::optional<double> bed_c;
  std::optional<double> bed_target_c;
  double highest_target_c = 0.0;  ///< of all heaters that report one: other tools and the chamber too
};

/// [mm], as the machine counts them.
struct ReportedPosition {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double e = 0.0;

  friend bool operator!=(const ReportedPosition& a, const ReportedPosition& b) {
    return a.x != b.x || a.y != b.y || a.z != b.z || a.e != b.e;
  }
};

/// A line of the firmware in Marlin's terms, into which other protocols translate theirs.
struct FirmwareReply {
  ReplyKind kind = ReplyKind::Information;
  std::optional<std::uint64_t> line;       ///< of a resend; of an ok by firmware with ADVANCED_OK
  std::optional<int> free_planner_blocks;  ///< P of an advanced ok
  std::optional<int> free_command_slots;   ///< B of an advanced ok
  std::optional<ReportedTemperatures> temperatures;
  std::optional<ReportedPosition> position;
  std::string text;           ///< the line, without end of line
  std::string firmware_name;  ///< of an answer to `M115`; empty in any other line
};

}  // namespace lamina
