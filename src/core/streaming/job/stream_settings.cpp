// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/job/stream_settings.hpp"

#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/streaming/job/firmware_protocol.hpp"

namespace lamina {

void describe(SettingsSchema& schema, StreamSettings& settings) {
  const Bounds times = Bounds::above(0.0, 86400.0);
  std::vector<std::string> firmware = firmwareProtocols().names();
  firmware.insert(firmware.begin(), kAnyFirmware);
  schema.choice("stream.firmware", settings.firmware, firmware,
                "Firmware of the machine; auto asks it, before anything else is sent.");
  schema.integer("stream.window_bytes", settings.window_bytes, {32, 65536},
                 "Bytes sent and not yet acknowledged; below the firmware's receive buffer.");
  schema.integer(
      "stream.window_lines", settings.window_lines, {0, 256},
      "Lines sent and not yet acknowledged, at most the firmware's command queue; 0 for 1 on a lossy "
      "link and 4 on a reliable one.");
  schema.choice<LinkKind>(
      "stream.link", settings.link,
      {{"auto", LinkKind::Auto}, {"lossy", LinkKind::Lossy}, {"reliable", LinkKind::Reliable}},
      "Whether bytes get lost or damaged on the way, as on a UART; auto goes by the port.");
  schema.integer("stream.max_line_bytes", settings.max_line_bytes, {0, 4096},
                 "Longest line the firmware takes, with number and checksum; 0 for its usual limit.");
  schema.number("stream.connect_timeout_s", settings.connect_timeout_s, times,
                "Time the machine has for its first answer.");
  schema.number(
      "stream.probe_after_s", settings.probe_after_s, times,
      "Time without an answer after which the machine is asked which line it has; above its busy interval.");
  schema.number("stream.settle_s", settings.settle_s, times,
                "Time without an answer after which lines sent behind a lost one are taken for discarded.");
  schema.number("stream.silence_timeout_s", settings.silence_timeout_s, times,
                "Time without an answer after which the job is aborted.");
  schema.number("stream.blocking_timeout_s", settings.blocking_timeout_s, times,
                "The same while homing, heating or waiting is under way.");
  schema.number("stream.safe_stop_timeout_s", settings.safe_stop_timeout_s, times,
                "Time the machine has to confirm a safe stop.");
  schema.flag("stream.keep_heaters_on", settings.keep_heaters_on, "Leave the heaters on after a safe stop.");
  schema.choice<EmergencyStop>(
      "stream.emergency_stop", settings.emergency_stop,
      {{"never", EmergencyStop::Never}, {"unconfirmed", EmergencyStop::Unconfirmed}},
      "Whether Klipper is shut down where a safe stop is not confirmed, by which it forgets its position.");
  schema.choice<UnlockPolicy>(
      "stream.unlock", settings.unlock, {{"never", UnlockPolicy::Never}, {"once", UnlockPolicy::Once}},
      "Whether a machine that has locked itself (grbl's alarm) is unlocked at the start; never refuses the "
      "job.");
  schema.text("stream.password_file", settings.password_file,
              "File whose first line is the password or API key of a print server; empty for none.");
  schema.integer("stream.temperature_interval_s", settings.temperature_interval_s, {0, 60},
                 "Interval of the machine's temperature reports; 0 for none.");
  schema.integer("stream.position_interval_s", settings.position_interval_s, {0, 60},
                 "Interval of the machine's position reports; 0 for none.");
  schema.text(
      "stream.journal", settings.journal,
      "File in which the progress of a job is kept; auto for one in the user's folder; empty for none.");
}

LinkKind linkOf(const std::string& port) {
  if (port.compare(0, 4, "tcp:") == 0) return LinkKind::Reliable;
  std::error_code error;
  const std::string device = std::filesystem::canonical(port, error).string();
  const std::string name = error ? port : device;
  for (const char* reliable : {"/dev/pts/", "/dev/ttyACM"})
    if (name.compare(0, std::string_view(reliable).size(), reliable) == 0) return LinkKind::Reliable;
  return LinkKind::Lossy;
}

int windowLines(const StreamSettings& settings, LinkKind link) {
  constexpr int kReliable = 4;  // Marlin's command queue (BUFSIZE)
  if (settings.window_lines > 0) return settings.window_lines;
  return link == LinkKind::Lossy ? 1 : kReliable;
}

void requireConsistent(const StreamSettings& settings) {
  if (settings.firmware != kAnyFirmware) firmwareProtocols().find(settings.firmware);
  if (settings.window_bytes >= settings.max_line_bytes) return;
  throw InvalidConfig("stream.window_bytes is " + std::to_string(settings.window_bytes) +
                      "; must be at least stream.max_line_bytes, " + std::to_string(settings.max_line_bytes));
}

}  // namespace lamina
