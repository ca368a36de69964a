// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lamina {

/// Exclusive or of all bytes: Marlin's check of a line, over everything before the '*'.
std::uint8_t marlinChecksum(std::string_view text);

/// "N<number> <command>*<checksum>\n".
std::string frameLine(std::uint64_t number, std::string_view command);

enum class ReplyKind : std::uint8_t {
  Ok,           ///< one line was taken; perhaps with its number, free buffers, temperatures
  Resend,       ///< the line to send again
  LineError,    ///< why a resend is asked for; the resend follows
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

struct MarlinTemperatures {
  double nozzle_c = 0.0;
  std::optional<double> nozzle_target_c;  ///< nothing if the firmware does not report it
  std::optional<double> bed_c;
  std::optional<double> bed_target_c;
};

/// [mm], as the machine counts them.
struct MarlinPosition {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double e = 0.0;

  friend bool operator!=(const MarlinPosition& a, const MarlinPosition& b) {
    return a.x != b.x || a.y != b.y || a.z != b.z || a.e != b.e;
  }
};

/// One line the firmware sent.
struct MarlinReply {
  ReplyKind kind = ReplyKind::Information;
  std::optional<std::uint64_t> line;       ///< of a resend; of an ok by firmware with ADVANCED_OK
  std::optional<int> free_planner_blocks;  ///< P of an advanced ok
  std::optional<int> free_command_slots;   ///< B of an advanced ok
  std::optional<MarlinTemperatures> temperatures;
  std::optional<MarlinPosition> position;
  std::string text;           ///< the line, without end of line
  std::string firmware_name;  ///< of an answer to `M115`; empty in any other line
};

/// What a line from the firmware means. Nothing is refused: an unknown line is Information, a resend whose
/// number cannot be read has no line. A greeting counts wherever it stands in the line, since a reset puts
/// stray bytes on the link, and whichever firmware sends it.
MarlinReply parseReply(std::string_view line);

}  // namespace lamina
