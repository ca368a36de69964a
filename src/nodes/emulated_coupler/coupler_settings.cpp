// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "coupler_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, EmulatedCouplerSettings& settings) {
  schema.text("bind", settings.bind, "Address that the coupler listens on.");
  schema.integer("port", settings.port, {0.0, 65535.0}, "Port that it listens on; 0 for any that is free.");
  schema.flag("ready", settings.is_ready, "Whether the device behind it says that it is ready.");
  schema.number("watchdog_s", settings.coupler.watchdog_s, {0.0, 60.0},
                "Time without a write to an output after which all take their fault values; 0 for none.");
  schema.number("dead_time_s", settings.coupler.dead_time_s, {0.0, 10.0},
                "From a write to the begin of its effect.");
  schema.number("lag_s", settings.coupler.lag_s, {0.0, 10.0}, "Time constant of the effect.");
}

}  // namespace lamina
