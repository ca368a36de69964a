// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings.hpp"

namespace lamina {

/// How a program is streamed to firmware.
struct StreamSettings {
  std::string firmware = "marlin";  ///< what it speaks, by its name (`firmwareProtocols`)
  int window_bytes = 127;         ///< sent and not yet acknowledged; less than the firmware's receive buffer
  int window_lines = 4;           ///< sent and not yet acknowledged; the firmware's command queue (BUFSIZE)
  int max_line_bytes = 96;        ///< the firmware's longest line (MAX_CMD_SIZE)
  double connect_timeout_s = 10;  ///< until the machine answers
  double probe_after_s =
      2.5;  ///< without an answer while lines are under way; above the firmware's busy interval
  double settle_s = 0.05;            ///< after which lines sent behind a lost one bring no answer any more
  double silence_timeout_s = 60;     ///< without an answer until the job is aborted
  double blocking_timeout_s = 3600;  ///< the same while homing, heating or waiting is under way
  double safe_stop_timeout_s = 10;   ///< until the machine has confirmed the safe stop
  bool keep_heaters_on = false;      ///< after a safe stop
  int temperature_interval_s = 1;    ///< of the firmware's own reports (M155); 0 for none
  int position_interval_s = 0;       ///< of the firmware's own reports (M154); 0 for none
};

/// Adds the keys stream.*.
void describe(SettingsSchema& schema, StreamSettings& settings);

/// @throws InvalidConfig if a line would not fit into the window, or nothing speaks to the firmware
void validate(const StreamSettings& settings);

}  // namespace lamina
