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
  Lossy,     ///< bytes may be lost or damaged, as by a UART, on the board or in a USB adapter
  Reliable,  ///< no byte is lost, since flow control makes the sender wait
};

/// What happens at the start of a job if the machine has locked itself (grbl's alarm). Its position may then
/// be lost.
enum class UnlockPolicy : std::uint8_t {
  Never,  ///< the job is refused
  Once,   ///< the machine is unlocked, and the job is run
};

/// When a machine gets an emergency stop (Klipper). The machine then loses its position.
enum class EmergencyStop : std::uint8_t {
  Never,        ///< never; the message of the failure suggests it
  Unconfirmed,  ///< if it has not confirmed the safe stop within `safe_stop_timeout_s`
};

/// The value of `stream.firmware` by which the protocol is chosen from the answer of the machine.
inline constexpr const char* kAnyFirmware = "auto";

/// How a program is streamed to firmware.
struct StreamSettings {
  std::string firmware = kAnyFirmware;  ///< name of its protocol in `firmwareProtocols`, or `auto`
  /// Most bytes that are sent and not yet acknowledged; less than the firmware's receive buffer.
  int window_bytes = 127;
  /// Most lines that are sent and not yet acknowledged; 0 for 1 on a lossy link and 4 on a reliable one.
  int window_lines = 0;
  LinkKind link = LinkKind::Auto;
  int max_line_bytes = 0;         ///< longest line that the firmware accepts; 0 for its usual limit
  double connect_timeout_s = 10;  ///< time within which the machine must first answer
  /// Time without an answer, while lines are under way, after which the machine is asked for its last line;
  /// must exceed the interval of the firmware's busy messages.
  double probe_after_s = 2.5;
  /// Time without an answer after which lines sent behind a lost one count as discarded by the firmware.
  double settle_s = 0.05;
  double silence_timeout_s = 60;     ///< time without an answer after which the job is aborted
  double blocking_timeout_s = 3600;  ///< silence timeout while the machine homes, heats or waits
  double safe_stop_timeout_s = 10;   ///< time within which the machine has to confirm a safe stop
  bool keep_heaters_on = false;      ///< whether a safe stop leaves the heaters on
  EmergencyStop emergency_stop = EmergencyStop::Never;
  UnlockPolicy unlock = UnlockPolicy::Never;
  std::string password_file;       ///< file with the password or API key of a print server; empty for none
  int temperature_interval_s = 1;  ///< interval of the firmware's temperature reports (M155); 0 for none
  int position_interval_s = 0;     ///< interval of the firmware's position reports (M154); 0 for none
  std::string journal = "auto";    ///< path of the progress file; empty for none (`journalPath`)
};

/// Adds the keys stream.*.
void describe(SettingsSchema& schema, StreamSettings& settings);

/// The kind of link by the name of a port, Lossy or Reliable; symbolic links are followed.
LinkKind linkOf(const std::string& port);

/// Number of lines that may be sent and not yet acknowledged: `window_lines`, or its default for the link. On
/// a lossy link the default is 1: firmware that refuses a damaged line discards the received bytes of later
/// lines, and reads the rest of a partly received line as a line without number.
/// @param link  `Auto` counts as reliable
int windowLines(const StreamSettings& settings, LinkKind link);

/// @throws InvalidConfig if `max_line_bytes` exceeds `window_bytes`, or there is no protocol of that name
void requireConsistent(const StreamSettings& settings);

}  // namespace lamina
