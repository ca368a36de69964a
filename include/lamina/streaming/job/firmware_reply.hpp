// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace lamina {

/// Kind of a line that the firmware sends.
enum class ReplyKind : std::uint8_t {
  Ok,           ///< one line was accepted; may state its number, free buffers, temperatures
  Resend,       ///< a request to send a line again
  LineError,    ///< the reason for a Resend, which follows
  Fatal,        ///< an error by which the firmware has halted or protects the machine
  Warning,      ///< an error that stops nothing
  Busy,         ///< a sign of life while the firmware works on earlier lines
  Start,        ///< the firmware has restarted, and has lost its state
  NotDone,      ///< a command was not run: it is unknown, or the nozzle is too cold to extrude
  Pause,        ///< the machine asks its host to pause, for example since filament has run out
  Resume,       ///< the machine continues after such a pause
  Cancel,       ///< the machine asks its host to end the job
  Unreadable,   ///< bytes that no firmware sends: noise on the link
  Information,  ///< reports and everything else
};

/// Temperatures that the firmware has reported.
struct ReportedTemperatures {
  double nozzle_c = 0.0;
  std::optional<double> nozzle_target_c;  ///< nothing if the firmware does not report it
  std::optional<double> bed_c;
  std::optional<double> bed_target_c;
  double highest_target_c = 0.0;  ///< highest target of all heaters, those of other tools and chamber too
};

/// Position that the firmware has reported [mm, the machine's coordinates]; e is the filament's.
struct ReportedPosition {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double e = 0.0;

  friend bool operator!=(const ReportedPosition& a, const ReportedPosition& b) {
    return a.x != b.x || a.y != b.y || a.z != b.z || a.e != b.e;
  }
};

/// A line that the firmware sends, parsed, in the terms of Marlin; other protocols translate theirs into
/// them.
struct FirmwareReply {
  ReplyKind kind = ReplyKind::Information;
  std::optional<std::uint64_t> line;       ///< number of the line that a Resend requests or an Ok names
  std::optional<int> free_planner_blocks;  ///< P of an Ok by firmware with ADVANCED_OK
  std::optional<int> free_command_slots;   ///< B of an Ok by firmware with ADVANCED_OK
  std::optional<ReportedTemperatures> temperatures;
  std::optional<ReportedPosition> position;
  std::string text;           ///< the line, without end of line
  std::string firmware_name;  ///< of an answer to `M115`; empty in any other line
};

}  // namespace lamina
