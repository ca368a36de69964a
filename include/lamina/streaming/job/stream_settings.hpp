// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/base/settings.hpp"

namespace lamina {

/// Whether bytes get lost or damaged between this computer and the firmware.
enum class LinkKind : std::uint8_t {
  Auto,      ///< by the port: network, pseudo-terminal and USB CDC (`ttyACM`) are reliable, all others lossy
  Lossy,     ///< a UART, at the board or behind a USB adapter
  Reliable,  ///< makes the sender wait instead
};

/// What is done with a machine that has locked itself (grbl's alarm), whose position may be lost.
enum class UnlockPolicy : std::uint8_t {
  Never,  ///< the job is refused
  Once,   ///< it is unlocked, and the job is run
};

/// Whether a machine that does not confirm its safe stop is shut down at once, by which it forgets its
/// position.
enum class EmergencyStop : std::uint8_t {
  Never,        ///< it is offered in the message of the failure
  Unconfirmed,  ///< once the time of the safe stop is over
};

/// The choice of `stream.firmware` that leaves it to who answers.
inline constexpr const char* kAnyFirmware = "auto";

/// How a program is streamed to firmware.
struct StreamSettings {
  std::string firmware = kAnyFirmware;  ///< what it speaks, by its name (`firmwareProtocols`)
  int window_bytes = 127;  ///< sent and not yet acknowledged; less than the firmware's receive buffer
  int window_lines = 0;    ///< sent and not yet acknowledged; 0 for 1 on a lossy link and 4 on others
  LinkKind link = LinkKind::Auto;
  int max_line_bytes = 0;         ///< the firmware's longest line; 0 for its usual one
  double connect_timeout_s = 10;  ///< until the machine answers
  double probe_after_s =
      2.5;  ///< without an answer while lines are under way; above the firmware's busy interval
  double settle_s = 0.05;            ///< after which lines sent behind a lost one bring no answer any more
  double silence_timeout_s = 60;     ///< without an answer until the job is aborted
  double blocking_timeout_s = 3600;  ///< the same while homing, heating or waiting is under way
  double safe_stop_timeout_s = 10;   ///< until the machine has confirmed the safe stop
  bool keep_heaters_on = false;      ///< after a safe stop
  EmergencyStop emergency_stop = EmergencyStop::Never;
  UnlockPolicy unlock = UnlockPolicy::Never;
  std::string password_file;       ///< of a print server's password or API key; empty for none
  int temperature_interval_s = 1;  ///< of the firmware's own reports (M155); 0 for none
  int position_interval_s = 0;     ///< of the firmware's own reports (M154); 0 for none
  std::string journal = "auto";    ///< path of the progress file; empty for none (`journalPath`)
};

/// Adds the keys stream.*.
void describe(SettingsSchema& schema, StreamSettings& settings);

/// What the port's name says of its link; of a link in the file system, where it leads to.
LinkKind linkOf(const std::string& port);

/// The lines that may be under way. Firmware that refuses a damaged line discards what it has received of the
/// lines behind it, and takes the rest of the one that is just arriving for a line without number: so on a
/// lossy link none may follow before the answer.
/// @param link  `Auto` counts as reliable
int windowLines(const StreamSettings& settings, LinkKind link);

/// @throws InvalidConfig if a line would not fit into the window, or nothing speaks to the firmware
void requireConsistent(const StreamSettings& settings);

}  // namespace lamina
