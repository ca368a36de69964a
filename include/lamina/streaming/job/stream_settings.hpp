// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Whether bytes get lost or damaged between this computer and the firmware.
enum class LinkKind : std::uint8_t {
  Auto,      ///< by the port: network, pseudo-terminal and USB CDC (`ttyACM`) are reliable, all others lossy
  Lossy,     ///< a UART, at the board or behind a USB adapter
  Reliable,  ///< one with flow control, which makes the sender wait
};

/// What is done about a machine that has locked itself (grbl's alarm) and whose position may be lost.
enum class UnlockPolicy : std::uint8_t {
  Never,  ///< the job is refused
  Once,   ///< it is unlocked, and the job is run
};

/// Whether a machine that does not confirm its safe stop is shut down at once, by which it loses its
/// position.
enum class EmergencyStop : std::uint8_t {
  Never,        ///< the message of the failure offers it
  Unconfirmed,  ///< after the timeout of the safe stop
};

/// The value of `stream.firmware` that stands for the firmware that answers.
inline constexpr const char* kAnyFirmware = "auto";

/// How a program is streamed to firmware.
struct StreamSettings {
  std::string firmware = kAnyFirmware;  ///< name of its protocol (`firmwareProtocols`)
  int window_bytes = 127;  ///< most bytes without acknowledgement; less than the firmware's receive buffer
  int window_lines = 0;    ///< most lines without acknowledgement; 0 for 1 on a lossy link and 4 on others
  LinkKind link = LinkKind::Auto;
  int max_line_bytes = 0;         ///< the firmware's longest line; 0 for its usual one
  double connect_timeout_s = 10;  ///< until the machine answers
  /// Time without an answer, while lines are under way, until the machine is asked for its last line; above
  /// the firmware's busy interval.
  double probe_after_s = 2.5;
  double settle_s = 0.05;            ///< after which lines sent after a lost one are no longer answered
  double silence_timeout_s = 60;     ///< time without an answer until the job is aborted
  double blocking_timeout_s = 3600;  ///< the same while homing, heating or waiting is under way
  double safe_stop_timeout_s = 10;   ///< until the machine has confirmed the safe stop
  bool keep_heaters_on = false;      ///< instead of switching them off at a safe stop
  EmergencyStop emergency_stop = EmergencyStop::Never;
  UnlockPolicy unlock = UnlockPolicy::Never;
  std::string password_file;       ///< file with the password or API key of a print server; empty for none
  int temperature_interval_s = 1;  ///< of the firmware's own reports (M155); 0 for none
  int position_interval_s = 0;     ///< of the firmware's own reports (M154); 0 for none
  std::string journal = "auto";    ///< path of the progress file; empty for none (`journalPath`)
};

/// Adds the keys stream.*.
void describe(SettingsSchema& schema, StreamSettings& settings);

/// The kind of link by the name of a port; symbolic links are followed.
LinkKind linkOf(const std::string& port);

/// Number of lines that may be under way. Firmware that refuses a damaged line discards what it has received
/// of the lines after it, and takes the rest of the line that is arriving for one without number. On a lossy
/// link no line may therefore be sent before the answer to the last one.
/// @param link  `Auto` counts as reliable
int windowLines(const StreamSettings& settings, LinkKind link);

/// Refuses settings that contradict each other.
/// @throws InvalidConfig if a line would not fit into the window, or there is no protocol of that name
void requireConsistent(const StreamSettings& settings);

}  // namespace lamina
