// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings.hpp"
#include "lamina/toolpath/motion_limits.hpp"

namespace lamina {

/// What an emulated machine is like.
struct EmulatedSettings {
  double speed_up = 1.0;         ///< machine time per wall time; 0 for as fast as possible
  int block_queue = 16;          ///< motions planned ahead
  int command_queue = 4;         ///< lines taken and not yet run
  int rx_buffer_bytes = 128;     ///< what comes while it is full is lost; 0 for no limit
  int max_line_bytes = 96;       ///< what a longer line has more is cut off
  bool emergency_parser = true;  ///< M108, M112 and M410 are heard at once, however full the queues are
  double busy_interval_s = 2.0;  ///< wall time between two busy messages
  double ambient_c = 25.0;
  double nozzle_heating_c_s = 5.0;
  double bed_heating_c_s = 2.0;
  double fault_delay_s = 0.2;    ///< wall time of a delayed ok
  double fault_silence_s = 1.0;  ///< wall time of a silence
  double fault_replug_s = 0.3;   ///< wall time from a disconnect until the link is back
  int fault_seed = 1;
  MotionLimits motion;
};

/// Adds the keys emulator.*; those of the motion limits belong to them.
void describe(SettingsSchema& schema, EmulatedSettings& settings);

}  // namespace lamina
