// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"
#include "lamina/toolpath/motion_limits.hpp"

namespace lamina {

/// Properties of an emulated machine.
struct EmulatedSettings {
  double speed_up = 1.0;         ///< machine time per wall time; 0 for as fast as possible
  int block_queue = 16;          ///< most motions that are planned ahead
  int command_queue = 4;         ///< most lines that are accepted and not yet run
  int rx_buffer_bytes = 128;     ///< size of the receive buffer, beyond which bytes are lost; 0 for no limit
  int max_line_bytes = 96;       ///< length after which a line is cut off
  bool emergency_parser = true;  ///< whether M108, M112 and M410 take effect on arrival, before queued lines
  double busy_interval_s = 2.0;  ///< wall time between two busy messages
  double ambient_c = 25.0;
  double nozzle_heating_c_s = 5.0;
  double bed_heating_c_s = 2.0;
  double bed_limit_c = 1000.0;  ///< highest temperature that the heater of the bed reaches
  bool moves_unhomed = true;  ///< whether axes move that are not homed, or whose motors were off after homing
  bool has_dryer = false;     ///< whether a pellet dryer is heated, as Marlin's chamber (M141, M191, C:)
  double dryer_heating_c_s = 0.1;
  int vacuum_zones = 0;          ///< number of vacuum zones, switched at the pins 1, 2, ... (M42, M43)
  double vacuum_time_s = 5.0;    ///< time constant of the pressure in a zone
  double vacuum_kpa = 10.0;      ///< final absolute pressure of a tight zone
  int leaking_zone = 0;          ///< number of the zone that leaks, from 1; 0 for none
  double leak_kpa = 70.0;        ///< final absolute pressure of the leaking zone
  double bump_mm = 0.2;          ///< height of a bump in the middle of the bed, as G29 measures it
  double fault_delay_s = 0.2;    ///< wall time by which a delayed ok is late
  double fault_silence_s = 1.0;  ///< wall time that a silence lasts
  double fault_replug_s = 0.3;   ///< wall time from a disconnect until the link is back
  int fault_seed = 1;
  MotionLimits motion;
};

/// Adds the keys emulator.*, and the keys of the motion limits.
void describe(SettingsSchema& schema, EmulatedSettings& settings);

}  // namespace lamina
