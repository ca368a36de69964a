// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/emulator/emulated_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, EmulatedSettings& settings) {
  const Bounds times{0.0, 3600.0};
  const Bounds rates = Bounds::above(0.0, 1e6);
  schema.number("emulator.speed_up", settings.speed_up, {0.0, 1000.0},
                "Machine time per wall time; 0 for as fast as possible.");
  schema.integer("emulator.block_queue", settings.block_queue, {1, 4096}, "Motions planned ahead.");
  schema.integer("emulator.command_queue", settings.command_queue, {1, 256}, "Lines taken and not yet run.");
  schema.integer("emulator.rx_buffer_bytes", settings.rx_buffer_bytes, {0, 1 << 24},
                 "Receive buffer; what comes while it is full is lost; 0 for no limit.");
  schema.integer("emulator.max_line_bytes", settings.max_line_bytes, {32, 4096},
                 "Longest line; what it has more is cut off.");
  schema.flag("emulator.emergency_parser", settings.emergency_parser,
              "Whether M108, M112 and M410 are heard at once, however full the queues are.");
  schema.number("emulator.busy_interval_s", settings.busy_interval_s, Bounds::above(0.0, 3600.0),
                "Wall time between two busy messages.");
  schema.number("emulator.ambient_c", settings.ambient_c, {-50.0, 100.0}, "Temperature of the room.");
  schema.number("emulator.nozzle_heating_c_s", settings.nozzle_heating_c_s, rates,
                "How fast the nozzle heats.");
  schema.number("emulator.bed_heating_c_s", settings.bed_heating_c_s, rates, "How fast the bed heats.");
  schema.number("emulator.bed_limit_c", settings.bed_limit_c, {0.0, 1000.0},
                "Temperature above which the bed does not get, whatever its target.");
  schema.flag("emulator.moves_unhomed", settings.moves_unhomed,
              "Whether axes move that were not homed, or whose motors were switched off.");
  schema.flag("emulator.has_dryer", settings.has_dryer,
              "Whether there is a dryer of pellets: M141, M191 and C: in reports.");
  schema.number("emulator.dryer_heating_c_s", settings.dryer_heating_c_s, rates, "How fast the dryer heats.");
  schema.integer("emulator.vacuum_zones", settings.vacuum_zones, {0, 64},
                 "Vacuum zones, on the pins from 1 on: M42 switches them, M43 reports their pressure.");
  schema.number("emulator.vacuum_time_s", settings.vacuum_time_s, Bounds::above(0.0, 3600.0),
                "Time in which the excess pressure of a zone falls to its e-th part.");
  schema.number("emulator.vacuum_kpa", settings.vacuum_kpa, {0.0, 101.325},
                "Pressure of a tight zone in the end.");
  schema.integer("emulator.leaking_zone", settings.leaking_zone, {0, 64}, "Zone that leaks; 0 for none.");
  schema.number("emulator.leak_kpa", settings.leak_kpa, {0.0, 101.325},
                "Pressure of the leaking zone in the end.");
  schema.number("emulator.bump_mm", settings.bump_mm, {-100.0, 100.0},
                "Height of a bump in the middle of the bed, as G29 finds it.");
  schema.number("emulator.fault_delay_s", settings.fault_delay_s, times, "Wall time of a delayed ok.");
  schema.number("emulator.fault_silence_s", settings.fault_silence_s, times, "Wall time of a silence.");
  schema.number("emulator.fault_replug_s", settings.fault_replug_s, times,
                "Wall time from a disconnect until the link is back.");
  schema.integer("emulator.fault_seed", settings.fault_seed, {0, 1000000000}, "Seed of the faults.");
  describe(schema, settings.motion);
}

}  // namespace lamina
